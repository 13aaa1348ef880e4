attitude-phi_right_angle = Drehung von Bild { $image }: phi = { NUM($phi_deg, decimals: 2) }° weicht weniger als 0,6° von 90° ab.
    .why = Bei 90° drehen omega und kappa um dieselbe Achse und sind nicht trennbar.
    .do = Diese Drehung weglassen.
