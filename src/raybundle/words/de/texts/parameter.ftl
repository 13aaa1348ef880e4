parameter-affinity = Affinität

parameter-angular_scale = Winkelmaßstab: Drehung des Winkelgebers durch x / c, minus 1

parameter-bias_shift_x = Versatz von x

parameter-bias_shift_y = Versatz von y

parameter-bias_x_columns = Änderung von x längs der Spalten

parameter-bias_x_rows = Änderung von x längs der Zeilen

parameter-bias_y_columns = Änderung von y längs der Spalten

parameter-bias_y_rows = Änderung von y längs der Zeilen

parameter-camera_constant = Kamerakonstante

parameter-camera_constant_stereographic = Kamerakonstante der stereografischen Projektion

parameter-correction = { $quantity ->
        [along] Position längs der Flugrichtung
        [across] Position quer zur Flugrichtung
        [up] Höhe der Position
        *[other] Drehwinkel um { $axis }
    }, { $curve ->
        [yes] Koeffizient { $number } in der Zeit
        *[no] Potenz { $number } der Zeit
    }

parameter-decentring = tangentiale Verzeichnung

parameter-detector_lever_arm = Hebelarm längs der { $axis }-Achse des Detektors

parameter-drift_x = Drift von X

parameter-drift_y = Drift von Y

parameter-drift_z = Drift von Z

parameter-eccentricity_across = Exzentrizität des Projektionszentrums quer zur Blickrichtung

parameter-eccentricity_along = Exzentrizität des Projektionszentrums längs der Blickrichtung

parameter-fourfold = vierzählige Verzeichnung

parameter-horizon = Bild des Horizonts

parameter-knot_x = Verschiebung in x, Knoten { $first }, { $second }

parameter-knot_y = Verschiebung in y, Knoten { $first }, { $second }

parameter-knots_height = Höhe des Knotenfelds: die des Formats; festgehalten

parameter-knots_width = Breite des Knotenfelds: die des Formats; festgehalten

parameter-lever_arm_backwards = Hebelarm nach hinten

parameter-lever_arm_right = Hebelarm nach rechts im Bild

parameter-lever_arm_up = Hebelarm nach oben im Bild

parameter-line_inclination = Neigung der Zeile längs der Blickrichtung

parameter-line_place = Lage der Zeile in der Bildebene, längs des Weges

parameter-line_tilt = Kippung der Zeile um die Blickrichtung

parameter-misalignment_viewing = Fehlausrichtung um die Aufnahmerichtung

parameter-misalignment_x = Fehlausrichtung um die x-Achse des Bildes

parameter-misalignment_y = Fehlausrichtung um die y-Achse des Bildes

parameter-motion_along = Bewegung längs des Weges

parameter-motion_backwards = Bewegung nach hinten

parameter-motion_change_along = Änderung der Bewegung längs des Weges

parameter-motion_change_backwards = Änderung der Bewegung nach hinten

parameter-motion_change_right = Änderung der Bewegung nach rechts

parameter-motion_right = Bewegung nach rechts

parameter-principal_point = Bildhauptpunkt

parameter-principal_point_line = Bildhauptpunkt auf der Zeile

parameter-radial = radiale Verzeichnung

parameter-radial_denominator = radiale Verzeichnung, Nenner

parameter-radial_ideal = radiale Verzeichnung am idealen Punkt

parameter-radial_line = radiale Verzeichnung längs der Zeile

parameter-radial_numerator = radiale Verzeichnung, Zähler

parameter-read_out = Auslesezeit durch Höhe des Formats

parameter-rig_kappa = Kappa der Kamera gegen das Rig

parameter-rig_omega = Omega der Kamera gegen das Rig

parameter-rig_phi = Phi der Kamera gegen das Rig

parameter-rig_x = Versatz des Projektionszentrums, x des Rigs

parameter-rig_y = Versatz des Projektionszentrums, y des Rigs

parameter-rig_z = Versatz des Projektionszentrums, z des Rigs

parameter-rotation_rate_viewing = Drehrate um die Aufnahmerichtung

parameter-rotation_rate_x = Drehrate um die x-Achse

parameter-rotation_rate_y = Drehrate um die y-Achse

parameter-shear = Scherung

parameter-shift_x = Versatz von X

parameter-shift_y = Versatz von Y

parameter-shift_z = Versatz von Z

parameter-sphere_radius = Radius der Kugel

parameter-range_offset = Verschiebung der Entfernung: Laufzeit des Signals, Uhr

parameter-range_rate = Änderung der Verschiebung mit der Entfernung

parameter-thin_prism_x = dünnes Prisma in x

parameter-thin_prism_y = dünnes Prisma in y

parameter-threefold = dreizählige Verzeichnung

parameter-time_of_line = Zeit der Trajektorie minus Zeit der Zeile

parameter-time_of_positions = Zeit der Positionen minus Zeit der Belichtungen

parameter-time_offset = Zeit der Tabellen minus Zeit der Zeilen

parameter-tumbling_cosine = Taumeln der Achse, Kosinus der doppelten Drehung

parameter-tumbling_sine = Taumeln der Achse, Sinus der doppelten Drehung

parameter-turn_change_viewing = Änderung der Drehung um die Aufnahmerichtung

parameter-turn_change_x = Änderung der Drehung um die x-Achse

parameter-turn_change_y = Änderung der Drehung um die y-Achse

parameter-turn_viewing = Drehung um die Aufnahmerichtung

parameter-turn_x = Drehung um die x-Achse

parameter-turn_y = Drehung um die y-Achse

parameter-twofold = zweizählige Verzeichnung

parameter-velocity_backwards = Geschwindigkeit nach hinten

parameter-velocity_right = Geschwindigkeit nach rechts

parameter-velocity_up = Geschwindigkeit nach oben im Bild

parameter-zero_radius = Radius, an dem die radialen Glieder null sind; eine Festlegung, nicht geschätzt
