float diffuse = max(dot(normal, lightDirection), 0.0);
