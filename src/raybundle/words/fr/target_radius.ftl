target_radius = Les rayons des cibles valent { NUM($ratio, decimals: 3) } ± { NUM($sigma, decimals: 3) } fois ceux des images ; le facteur est estimé.
