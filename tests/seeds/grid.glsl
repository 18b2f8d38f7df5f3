floor(p.xz/gridSize)
