conversion-rigs = Kameras eines Trägers werden als einzelne Kameras geschrieben: { LIST($cameras, most: 8) }.

conversion-read_out = Das Format enthält das Auslesen der Kamera { $camera } nicht: Bildpunkte verschieben sich um bis zu { NUM($largest_px, digits: 2) } px.
    .why = Sie liegen dort, wo sie bei gleichzeitigem Auslesen aller Zeilen lägen; die Fotos sind unverändert.

conversion-in_metres = Der Block ist in { $unit }; seine Koordinaten werden in m geschrieben, der Einheit von { $format }.

conversion-free_scale = Der Maßstab des Blocks ist frei, weil keine Länge ihn festlegt: Längen in der Datei haben keine Einheit.

conversion-not_oriented = { $n } von { $total } Bildern sind nicht orientiert und entfallen: { $names }.

conversion-no_coordinates = { $n } von { $total } Punkten haben keine Koordinaten und entfallen: { $names }.

conversion-not_held = Das Format hat keinen Platz für { $points ->
        [0] {""}
        [one] { $points } Punkt und{" "}
        *[other] { $points } Punkte und{" "}
    }{ $observations } { $observations ->
        [one] Bildbeobachtung
        *[other] Bildbeobachtungen
    }; sie sind weggelassen.

conversion-camera_fitted = Kamera { $camera } wird als { $model } geschrieben, über das Format angepasst: größte Abweichung { $largest_px } px.

conversion-measured_points = Bildpunkte sind die gemessenen, in { $unit } um die Bildmitte.
    .why = Hauptpunkt und Verzeichnung stehen nur in { $table }.
    .do = Diese im anderen Programm eingeben oder die Fotos zuvor entzerren: { OPTION("undistort") }.

conversion-dxf_unit = DXF hat keinen Code für die Einheit { $unit }; die Zeichnung gibt keine an.

conversion-height_unit = Höhen sind in { $heights }, Ost und Nord in { $plan }, wie im Koordinatensystem.

conversion-system = Koordinaten werden in { $system } geschrieben.

conversion-nerfstudio_images = nerfstudio erwartet die Fotos in images/ neben der Datei.

conversion-kml_heights = Betrachter zeigen diese ellipsoidischen Höhen um die Geoidundulation versetzt.
    .why = Höhen in KML beziehen sich auf den Meeresspiegel.

conversion-plane_axes = Koordinaten werden in den Achsen der Ebene{ $unit ->
        [none] {" (ohne Einheit)"}
        *[other] {" "}[{ $unit }]
    } geschrieben: X nach rechts, Y nach oben, Z aus ihr heraus.
    .why = Ihre Standardabweichungen vernachlässigen die Korrelationen zwischen den Koordinaten des Blocks.

conversion-no_system = Der Block hat kein Koordinatensystem; seine eigenen Achsen{ $unit ->
        [none] {" (ohne Einheit)"}
        *[other] {" "}[{ $unit }]
    } werden geschrieben.
    .why = Die Datei gibt an, dass sie lokal sind.

conversion-no_footprint = { $n } { $n ->
        [one] Foto hat
        *[other] Fotos haben
    } keinen Umriss am Boden: Nicht alles davon zeigt den Boden von oben.

conversion-system_beside = Das Koordinatensystem steht in { $name }, die Lage in der World-Datei.
    .why = { $tiff ->
        [yes] rasterio, das GeoTIFF schreibt, ist nicht installiert.
        *[no] {""}
    }
    .do = { $tiff ->
        [yes] Um GeoTIFF zu schreiben, es installieren: pip install 'raybundle[geo]'
        *[no] {""}
    }

conversion-outside_undistorted = { $n } { $n ->
        [one] Bildbeobachtung liegt
        *[other] Bildbeobachtungen liegen
    } außerhalb der verzeichnungsfreien Bilder und { $n ->
        [one] entfällt.
        *[other] entfallen.
    }

conversion-photograph_left_out = { $name } entfällt:

conversion-no_colours = { $name } liefert keine Farben:

conversion-new_rpc = { $name }: ein neues RPC für Höhen von { NUM($low_m, decimals: 0) } bis { NUM($high_m, decimals: 0) } m, mit Abweichungen bis { NUM($largest_px, digits: 2) } px.

conversion-local_frame = Der Block wird von { $system } in ein lokales System (Ost, Nord, oben) transformiert.
    .why = Sein Ursprung ist { NUM($x, decimals: 3) }; { NUM($y, decimals: 3) }; { NUM($z, decimals: 3) }.

conversion-scenes_without_stations = Von Satellitenszenen ({ $scenes }) werden die Punkte geschrieben; ihre Standpunkte in 600 km Höhe nicht.

conversion-scenes_nominal_stations = Satellitenszenen ({ $scenes }) liefern Punkte; ihre Standpunkte sind nominelle Blickpunkte in 600 km Höhe.

conversion-no_scenes = Satellitenszenen entfallen: { $scenes }.

conversion-few_rays = { $n } { $n ->
        [one] Verknüpfungspunkt entfällt
        *[other] Verknüpfungspunkte entfallen
    }: jeweils weniger als { $least } Bildbeobachtungen.

conversion-rejected_observations = { $n } verworfene { $n ->
        [one] Bildbeobachtung entfällt.
        *[other] Bildbeobachtungen entfallen.
    }

conversion-rejected_points = { $n } { $n ->
        [one] Verknüpfungspunkt entfällt
        *[other] Verknüpfungspunkte entfallen
    }: Alle ihre Bildbeobachtungen sind verworfen.
