# $camera = "RMK"
certificate-not_positive = Camera { $camera }: camera constant and format must be positive.
    .do = Correct the certificate.

# $camera = "RMK"
# $radii = 9
# $distortions = 8
certificate-distortion_table = Camera { $camera }: { $radii } radii and { $distortions } distortions do not belong together.
    .do = Give one distortion for each radius (0 or above).
