// May mainImage be missing?
float g() { return 1.; }
