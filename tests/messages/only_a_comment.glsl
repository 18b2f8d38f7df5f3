// To be written tomorrow.
