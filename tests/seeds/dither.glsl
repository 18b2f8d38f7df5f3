t += hash(fragCoord) * step_size
