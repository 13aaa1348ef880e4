scene-file = Szene: { $parts }.

scene-points = { $n } { $which ->
        [ground] { $n ->
            [one] Objektpunkt
            *[other] Objektpunkte
        }
        *[image] { $n ->
            [one] Bildpunkt
            *[other] Bildpunkte
        }
    } berechnet.

scene-fitted = RPC angepasst: RMS { $x }, { $y } px an { $n } unabhängigen Punkten, größte Abweichung { $largest } px.

scene-fit_heights = Höhen { $low } bis { $high } m, Regularisierung { $strength }.

scene-rpc = RPC: Mitte { NUM($longitude, decimals: 5) } O, { NUM($latitude, decimals: 5) } N, Höhen { NUM($low, decimals: 0) } bis { NUM($high, decimals: 0) } m.

scene-pixel = Pixel am Boden: { $x } m in x, { $y } m in y.

scene-stated_bias = Angegebener Versatz: { $bias_m } m (68 %), { $x }, { $y } px.

scene-rigorous = Strenges Modell: { $kind ->
        [linescan] Zeilenkamera
        [push_frame] Push-Frame-Kamera
        [frame] Flächenkamera
        [optical_bar] Panoramakamera (optical bar)
        [range_doppler] Radar
       *[other] { $kind }
    }{ $kind ->
        [frame] {""}
       *[other] {", "}{ NUM($seconds, digits: 4) } s
    }, Ecken in der Höhe { $height } m.

scene-corner = Ecke { NUM($x, decimals: 0) }, { NUM($y, decimals: 0) }: { $known ->
        [yes] { NUM($longitude, decimals: 6) } O, { NUM($latitude, decimals: 6) } N
        *[no] blickt am Körper vorbei
    }

scene-agreement = Strenges Modell minus RPC: Mittel { $x }, { $y } px, Standardabweichung { $std_x }, { $std_y } px.
    .why = Über die Szene und 80 % der Höhen.

scene-ortho = Orthophoto: { $width } x { $height } px zu { $pixel } in { $crs }, { PERCENT($share, digits: 3) } % gesehen (keine Daten: { $nodata }).

scene-corrected = Korrigiert: { $n } von { $of } { $of ->
        [one] Szene
        *[other] Szenen
    }.

scene-no_common_ground = Sie zeigt keinen Boden einer anderen Szene und ist nicht markiert.

scene-few_common_points = Sie hat { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } mit anderen Szenen gemeinsam ({ $needed } sind nötig).

scene-control_system = { $name }: in { $system } genommen{ $given ->
        [yes] {""}
        *[no] {" "}(Länge, Breite, ellipsoidische Höhe)
    }.

scene-ground_outside_heights = Der Boden der Szene liegt { NUM($low_m, decimals: 0) } bis { NUM($high_m, decimals: 0) } m über dem Ellipsoid.
    .why = Das RPC gilt für Höhen von { NUM($lowest_m, digits: 6) } bis { NUM($highest_m, digits: 6) } m.
    .do = Das Geoid und die Einheit der Höhen prüfen.

scene-height_outside = Höhe { NUM($height_m, digits: 6) } m; das RPC gilt für { NUM($lowest_m, digits: 6) } bis { NUM($highest_m, digits: 6) } m.

scene-outside_area = Außerhalb der Fläche des RPC.

scene-outside_picture = x { NUM($x_px, decimals: 1) }, y { NUM($y_px, decimals: 1) } liegt außerhalb des Bildes von { $width_px } x { $height_px } px.

scene-other_body = Der Körper ist nicht die Erde; andere Programme werden für dieses RPC WGS 84 annehmen.
