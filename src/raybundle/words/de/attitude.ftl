attitude-phi_right_angle = Drehung von Bild { $image }: phi = { NUM($phi_deg, decimals: 2) }° weicht weniger als 0,6° von 90° ab.
    .why = Bei 90° drehen omega und kappa um dieselbe Achse und sind nicht trennbar.
    .do = Diese Drehung weglassen.

attitude-missing = Lagewinkel fehlen: Weder { OPTION("positions") } noch die Aufnahmen enthalten sie.
    .do = Eine CSV-Datei mit omega_deg, phi_deg, kappa_deg oder roll_deg, pitch_deg, yaw_deg angeben.

attitude-other_convention = Die Lagewinkel { $source ->
     [gimbal] des Gimbals
     *[other] aus { $source }
    } haben die Konvention { $convention }, nicht { $expected }.
    .do = { OPTION("attitudes", "auto") } angeben.

attitude-no_sigma = Die Lagewinkel { $source ->
     [gimbal] des Gimbals
     *[other] aus { $source }
    } haben keine Standardabweichungen.
    .do = { OPTION("attitude_sigma", "TILT", "HEADING") } in Grad angeben.

attitude-no_sigma_unused = Die Lagewinkel { $source ->
     [gimbal] des Gimbals
     *[other] aus { $source }
    } werden ohne Standardabweichungen nicht verwendet.
    .do = { OPTION("attitude_sigma", "TILT", "HEADING") } in Grad angeben, um sie zu beobachten.
