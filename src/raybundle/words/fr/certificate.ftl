certificate-not_positive = Caméra { $camera } : la constante et le format doivent être positifs.

certificate-distortion_table = Caméra { $camera } : { $radii } rayons et { $distortions } distorsions ne concordent pas.
