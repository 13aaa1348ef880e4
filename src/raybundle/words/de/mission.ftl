mission-no_crs = Die Mission hat lokale Koordinaten; ein Fluggerät braucht Positionen auf der Erde.
    .do = Die Mission in einem Koordinatensystem planen: { OPTION("crs", "EPSG:CODE") }.

mission-vehicle_unknown = Das Fluggerät { $vehicle } ist unbekannt.
    .do = Eines von { LIST($known, most: 20) } verwenden oder { OPTION("speed", "M_S") }, { OPTION("climb", "M_S") }, { OPTION("battery", "MINUTES") } angeben.

mission-camera_missing = Die Kamera fehlt.
    .do = Ein Fluggerät ({ LIST($known, most: 20) }) oder { OPTION("camera") } als Aufnahme, Kalibrierung oder WIDTHxHEIGHT,C in Pixeln angeben.

mission-camera_unknown = Die Kamera { $camera } ist weder eine Datei noch eine bekannte Kamera.
    .do = Eine von { LIST($known, most: 20) } verwenden oder WIDTHxHEIGHT,C in Pixeln, etwa 5472x3648,3650.

mission-no_folder = Die Datei hat keinen Ordner mit Wegpunkten; sie wurde nicht als Mission geschrieben.
    .do = Prüfen, ob es die richtige Datei ist.

mission-no_way_point = Die Mission hat keinen Wegpunkt.
    .do = Prüfen, ob es die richtige Datei ist.

mission-no_height = Die Höhe über dem Startpunkt fehlt; die Datei wurde nicht als Mission geschrieben.
    .do = Prüfen, ob es die richtige Datei ist.

mission-height_reference = Die Höhen beziehen sich auf { $reference }; unterstützt werden nur Höhen über dem Startpunkt ({ $needed }).
    .do = Die Mission mit diesen Höhen speichern.

mission-no_table = Die Datei hat kein [way_points]; sie ist kein Flugplan.
    .do = Prüfen, ob es die richtige Datei ist.

mission-columns = Die Spalten der Wegpunkte weichen von den nötigen ab.
    .do = { LIST($needed, most: 12) } angeben.

mission-line_unknown = Die Fluglinie { $line_number } gibt es nicht; definiert sind { $n }, ab 0 gezählt.
    .do = Die Nummer korrigieren.

mission-unknown_pattern = Das Flugmuster { $pattern } ist unbekannt.
    .do = Eines von { LIST($known, most: 20) } verwenden.

mission-area_in_zones = Flugverbotszonen bedecken das ganze Gebiet der Befliegung.
    .do = Die Zonen und ihr Koordinatensystem prüfen.

mission-too_many_photographs = Die Befliegung braucht { $n } Aufnahmen; möglich sind höchstens { $most }.
    .do = Eine größere Bodenauflösung ({ OPTION("gsd") }) verwenden oder das Gebiet teilen.

mission-line_no_extent = Alle Punkte der Linie sind identisch.
    .do = Mindestens zwei verschiedene Punkte angeben.

mission-speed_of_vehicle = Eine Geschwindigkeit von { $speed_mps } m/s übersteigt die { $most_mps } m/s von { $vehicle }.
    .do = Eine kleinere Geschwindigkeit angeben: { OPTION("speed") }.

mission-camera_interval = Kamera { $camera } braucht { $interval_s } s zwischen Aufnahmen; die Befliegung hat { NUM($needed_s, decimals: 2) } s.
    .why = Die Basis ist { NUM($base_m, decimals: 2) } m bei { $speed_mps } m/s.
    .do = Höchstens { NUM($most_mps, decimals: 1) } m/s fliegen ({ OPTION("speed") }), höher oder mit weniger Überdeckung ({ OPTION("overlap") }).

mission-battery = { $flight_line } ist mit einem Akku nicht erreichbar: Hin- und Rückweg dauern { NUM($needed_min, decimals: 1) } min.
    .why = Nutzbar sind { NUM($usable_min, decimals: 1) } von { $minutes_min } min.
    .do = Näher starten ({ OPTION("take_off") }) oder ein Fluggerät mit längerer Flugzeit verwenden ({ OPTION("battery") }).

mission-no_stop = Wegpunkt { $waypoint } beginnt Aufnahmen, aber kein späterer beendet sie.
    .do = Danach einen Halt der Aufnahmen ergänzen.

mission-no_photographs = Die Befliegung hat keine Aufnahme: Kein Wegpunkt beginnt oder macht eine.
    .do = Eine Befliegung mit Aufnahmen angeben.

mission-base_not_positive = Wegpunkt { $waypoint }: Die Basis zwischen Aufnahmen ist { $base_m } m.
    .do = Eine Basis über 0 angeben.

mission-too_many_on_line = Wegpunkt { $waypoint } beginnt { $n } Aufnahmen, eine alle { $base_m } m; möglich sind höchstens { $most }.
    .do = Eine längere Basis angeben.

mission-view_to_horizon = Ein um { NUM($tilt_deg, decimals: 0) }° geneigter Blick mit { NUM($angle_deg, decimals: 0) }° Bildwinkel reicht bis zum Horizont.
    .do = Eine Neigung unter { NUM($most_deg, decimals: 0) }° angeben: { OPTION("tilt") }.

mission-too_many_parts = Die Befliegung braucht { $n } { $kind ->
        [lines] Streifen
        [rows] Reihen
       *[photographs] Aufnahmen
     }; möglich sind höchstens { $most }.
    .do = Das Koordinatensystem des Gebiets und die Bodenauflösung in Metern ({ OPTION("gsd") }) prüfen.

mission-heights_missing = Die Höhen des Objekts über Grund fehlen.
    .do = { OPTION("heights", "LOW", "TOP") } angeben.

mission-heights_order = Die Oberkante des Objekts, { $top_m } m, liegt nicht über der Unterkante, { $low_m } m.
    .do = { OPTION("heights") } korrigieren.

mission-vehicle_not_positive = Fluggerät { $vehicle }: { $entry } ist { $value }.
    .do = Einen Wert über 0 angeben.

mission-way_in_zone = Ein Weg { $end ->
        [begins] beginnt
       *[ends] endet
     } in einer Flugverbotszone, bei { NUM($x, decimals: 1) }; { NUM($y, decimals: 1) }.
    .do = Den Startplatz ({ OPTION("take_off") }) oder die Zone verlegen.

mission-no_way = Kein Weg von { NUM($x, decimals: 1) }; { NUM($y, decimals: 1) } nach { NUM($to_x, decimals: 1) }; { NUM($to_y, decimals: 1) } umgeht die Flugverbotszonen.
    .do = Auf derselben Seite der Zonen starten oder sie öffnen.

mission-name = { $name } ist als Dateiname nicht möglich.
    .do = { OPTION("name") } aus Buchstaben, Ziffern, Leerzeichen, Punkten, - und _ angeben.

mission-gsd_too_large = { OPTION("gsd", $gsd_m) }: Dieses Pixel braucht einen Abstand von { NUM($distance_m, decimals: 0) } m (Grenze { NUM($limit_m, decimals: 0) } m).
    .why = Die Grenze ist das { $times }-Fache von { OPTION("height_limit") }.
    .do = Die Pixelgröße in Metern angeben{ $unit ->
        [cm] ; vermutlich ist sie in Zentimetern
        [mm] ; vermutlich ist sie in Millimetern
       *[other] { "" }
     }.

mission-shape = Das Muster { $pattern } braucht { $wanted ->
        [area] ein Polygon
        [line] eine Linie
       *[place] einen Punkt oder ein Polygon
     }; { $area } enthält { $kind ->
        [area] Polygone
        [line] Linien
       *[place] Punkte
     }.
    .do = { OPTION("pattern") } anders wählen oder eine andere Datei angeben.

mission-several_outlines = { $area } enthält { $n } Umrisse; eine Mission hat einen.
    .do = Die Umrisse einzeln angeben oder zu einem verbinden.

mission-blur = Bei { $speed } m/s und 1/{ $exposure } s bewegt sich das Bild um { NUM($blur, decimals: 1) } px (Grenze { $limit } px).
    .do = Fliegen Sie mit { NUM($slower, decimals: 1) } m/s, oder belichten Sie kürzer.

mission-zones_taken_out = Durch Sperrgebiete entfallen { $kind ->
    [metres] { NUM($metres, decimals: 0) } m der Linien
    *[photographs] { $n ->
        [one] eine Aufnahme
        *[other] { $n } Aufnahmen
    }
 }.
    .why = Was nur von dort sichtbar ist, wird nicht aufgenommen.

mission-speed_limited = { $limit ->
    [camera_interval] Die Bildfolgezeit der Kamera
    *[blur] Die Bewegungsunschärfe
 } begrenzt die Geschwindigkeit auf { NUM($speed, decimals: 1) } m/s (Fluggerät: { $vehicle } m/s).

mission-ground_too_steep = Das Gelände ist steiler, als das Fluggerät bei { NUM($speed, decimals: 1) } m/s steigt: bis { NUM($raised, decimals: 1) } m zu hoch.
    .do = Fliegen Sie langsamer, um dem Gelände zu folgen.

mission-too_high = Aufnahmen liegen bis { NUM($height_m, decimals: 0) } m über Grund; erlaubt sind { $limit_m } m{ $open_category ->
        [yes] {" "}(EU 2019/947, offene Kategorie)
        *[no] {""}
    }.
    .do = Planen Sie eine kleinere Bodenauflösung, folgen Sie dem Gelände, oder erhöhen Sie { OPTION("height_limit") }, wo das genehmigt ist.

mission-out_of_sight = Der Flug entfernt sich bis { NUM($distance_m, decimals: 0) } m vom Startplatz; die Sichtweite ist { $limit_m } m ({ OPTION("sight") }).
    .do = Starten Sie näher an der Mitte, oder teilen Sie das Gebiet.

mission-battery_exceeded = Ein Flug dauert { NUM($minutes, decimals: 1) } min; { NUM($usable, decimals: 1) } min eines Akkus sind nutzbar.
    .do = Teilen Sie das Gebiet, oder geben Sie die Flugzeit des Akkus an ({ OPTION("battery") }).

mission-interval_short = Aufnahmen folgen im Abstand von { NUM($interval_s, decimals: 2) } s; Kamera { $camera } braucht { $needed_s } s.
    .do = Fliegen Sie langsamer ({ OPTION("speed") }).

mission-rolling_motion = Während ein Bild ausgelesen wird, bewegt sich der Rolling Shutter am Boden um { NUM($motion_px, decimals: 1) } px.
    .do = Halten Sie für die Aufnahmen an, fliegen Sie langsamer, oder gleichen Sie mit der Plattform rolling aus.

mission-seen_rarely = { NUM(PERCENT($share), decimals: 1) } % des Gebiets sind in weniger als { $photographs } Aufnahmen.
    .why = { $where ->
        [middle] { PERCENT($along) } % längs und { PERCENT($across) } % quer sind für seine Mitte zu wenig.
        [zones] Diese Stellen liegen an Flugverbotszonen.
        *[edges] Diese Stellen liegen an seinen Rändern.
    }
    .do = { $where ->
        [middle] Erhöhen Sie die Überdeckung ({ OPTION("overlap") }).
        [zones] Neigen Sie die Blicke zu den Zonen ({ OPTION("tilt") }), oder verkleinern Sie diese.
        *[edges] Vergrößern Sie den Rand ({ OPTION("margin") }).
    }

mission-overlap_low = Die Überdeckung { $direction ->
        [along] längs der Streifen
        *[across] quer zu den Streifen
    } ist nur { PERCENT($overlap) } %; verlangt sind { PERCENT($asked) } %.
    .why = { $cause ->
        [relief] Streifen folgen den Höhen unter ihnen; höheres Gelände daneben ist näher.
        [facade] So weit liegen die Reihen vor der Fassade auseinander.
        [orbit] So weit liegen Aufnahmen und Ringe um das Objekt auseinander.
        *[pattern] So weit liegen die Streifen auseinander.
    }
    .do = { $cause ->
        [relief] Fliegen Sie höher ({ OPTION("gsd") }, { OPTION("height") }), oder erhöhen Sie die Überdeckung ({ OPTION("overlap") }).
        [orbit] Erhöhen Sie die Überdeckung ({ OPTION("overlap") }), oder die Zahl der Ringe ({ OPTION("rings") }).
        *[pattern] Erhöhen Sie die Überdeckung ({ OPTION("overlap") }).
    }

mission-holes_flown_over = Löcher im Gebiet werden überflogen.
    .do = Um sie auszusparen, geben Sie sie als Flugverbotszonen an ({ OPTION("no_go") }).

mission-ground_holes = { $n } { $n ->
        [one] Loch
        *[other] Löcher
    } in den Geländehöhen, { NUM(PERCENT($share), decimals: 1) } % des Gebiets; Überdeckungen dort sind unbekannt.
    .why = Das größte misst { NUM($width_m, decimals: 0) } x { NUM($length_m, decimals: 0) } m bei { NUM($x, decimals: 0) }; { NUM($y, decimals: 0) }.

mission-too_many_way_points = { $name } hat { $n } Wegpunkte; { $program } nimmt { $most }.
    .do = Folgen Sie dem Gelände weniger eng ({ OPTION("follow") }), oder teilen Sie das Gebiet.
