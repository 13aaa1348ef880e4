join-one_block = Zum Verbinden sind mindestens zwei Blöcke nötig.
    .do = Zwei oder mehr Projekte oder Blöcke angeben.

join-too_few_common = { $name } und { $base } haben { $n } { $n ->
        [one] gemeinsamen Punkt
       *[other] gemeinsame Punkte
     } mit Koordinaten; nötig sind { $least }.
    .why = Es zählen benannte und codierte Punkte.
    .do = Mehr gemeinsame Punkte in beiden Blöcken messen.

join-control_contradicts = Punkt { $point }: Gegebene Koordinaten in { $name } und { $base } unterscheiden sich um { $apart } { $unit } (Grenze { $limit } { $unit }).
    .why = { $others ->
        [0] Die Grenze folgt aus den Standardabweichungen.
        [one] Die Grenze folgt aus den Standardabweichungen. 1 weiterer Punkt widerspricht ebenfalls.
       *[other] Die Grenze folgt aus den Standardabweichungen. { $others } weitere Punkte widersprechen ebenfalls.
     }
    .do = Die Koordinaten korrigieren oder beide Blöcke in ein Koordinatensystem transformieren.

join-vertical_tilted = Das System von { $base } ist um { NUM($tilt_deg, digits: 2) }° gegen die Lotrichtung von { $name } geneigt.
    .why = { $name } hat Beobachtungen, die sich auf die Lotrichtung beziehen: { $tables }.
    .do = { $name } zuerst angeben oder auch { $base } horizontieren.

join-cameras_differ = Kamera { $camera } von { $name } ist nicht die gleichnamige Kamera des anderen Blocks.
    .why = Die Kameras sind { $model }, { $width_px } x { $height_px } px, und { $other_model }, { $other_width_px } x { $other_height_px } px.
    .do = Die beiden Kameras als verschiedene behandeln.

join-scale_of = Maßstab von { $name }: { $kind ->
        [control] Passpunkte
        [positions] beobachtete Positionen
       *[bars] { $n ->
            [0] unbekannt
            [one] eine Maßstabsstrecke
           *[other] { $n } Maßstabsstrecken
        }
     }.

join-scale_bar = Maßstabsstrecke { $start } - { $end }: { NUM($length, digits: 10) } { $unit }.

join-same_measurement = Alle Aufnahmen von { $name } ({ $n }) haben in { $first } und in { $second } dieselben Bildpunkte.
    .why = Diese Aufnahmen würden doppelt zählen: { LIST($names, most: 3) }.
    .do = { $name } weglassen.

join-same_photographs = { $n } { $n ->
        [one] Aufnahme hat
       *[other] Aufnahmen haben
     } in { $first } und in { $second } dieselben Bildpunkte: { LIST($names, most: 3) }.
    .why = Diese Aufnahmen zählen doppelt, und die Standardabweichungen werden zu klein.
    .do = Diese Aufnahmen aus einem der beiden Blöcke ausschließen.

join-too_few_to_test = Kein gemeinsamer Punkt ist geprüft: { $name } und { $base } haben weniger als { $least }.

join-points_not_tested = Gemeinsame Punkte von { $name } sind nicht geprüft:

join-block_not_adjusted = Kein gemeinsamer Punkt ist geprüft: { $name } lässt sich nicht allein ausgleichen:

join-points_moved = { $moved } von { $n } gemeinsamen Punkten von { $name } und { $base } sind nicht derselbe Punkt.
    .do = Prüfen, ob Namen zu einem anderen Objekt gehören oder vertauscht sind.

join-scales_not_tested = Die Maßstäbe von { $base } und { $name } sind nicht verglichen:

join-scales_contradict = Längen von { $name } sind das { NUM($factor, digits: 7) }-Fache (± { NUM($sigma, digits: 2) }) derer von { $base }.
    .why = Einer der beiden Maßstäbe ist falsch.
    .do = Diese Längen prüfen:

join-frames_contradict = { $name } und { $base } liegen nicht im selben Koordinatensystem: Verschiebung { NUM($shift_m, digits: 2) } m, Drehung { NUM($turn_mrad, digits: 2) } mrad (F { $F }).
    .do = Die Passpunkte beider Blöcke vergleichen.

join-other_unit = Längen von { $name } sind das { NUM($factor, digits: 6) }-Fache derer von { $base }.
    .why = { $likely ->
        [yes] Vermutlich ist { $name } in { $unit } und { $base } in { $base_unit }.
       *[no] Die Einheit von einem der beiden ist falsch.
     }
    .do = Längen in der Einheit von block.toml angeben:

join-cameras_not_compared = Kameras von { $name } und { $base } sind nicht verglichen:

join-camera_contradicts = Kamera { $camera } ist in { $base } und in { $name } nicht dieselbe (Grenze { $limit } Standardabweichungen).
    .why = { $symbol } ist { NUM($first, digits: 6) } { $unit } in { $base } und { NUM($second, digits: 6) } { $unit } in { $name }{ $held ->
        [yes] { "" }, beide fest
       *[no] { "" }, { NUM($times, digits: 2) } Standardabweichungen auseinander
     }.
    .do = { OPTION("same_camera") } weglassen: Jedes Projekt hat dann seine eigene Kamera.

join-camera_differs = Kamera { $camera } unterscheidet sich signifikant zwischen { $base } und { $name } (F { $F }).
    .why = { $symbol } ist { NUM($first, digits: 6) } { $unit } in { $base } und { NUM($second, digits: 6) } { $unit } in { $name }{ $held ->
        [yes] { "" }, beide fest
       *[no] { "" }, { NUM($times, digits: 2) } Standardabweichungen auseinander
     }.
    .do = Prüfen, ob Fokus oder Zoom geändert wurden.

join-dots_renumbered = Punkte ohne Code sind neu nummeriert: { $n } sind nach der Lage gemeinsam, { $others } von { $names } haben neue Nummern.
    .why = Die Nummern solcher Punkte sind je Block verschieden; die Messungen ändern sich nicht.
    .do = In Tabellen für den gemeinsamen Block die neuen Nummern verwenden.

join-points_beyond_sigma = Nicht bewegte gemeinsame Punkte von { $name } weichen stärker ab, als ihre Standardabweichungen erklären (F { $F }).
    .why = Diese sind zu klein, oder viele Punkte haben sich ein wenig bewegt.

join-frame_of = Das Koordinatensystem ist das von { $name } mit { $control ->
        [yes] Passpunkten oder Positionen
       *[no] einem Maßstab
     }.
    .why = Alle Koordinaten des gemeinsamen Blocks liegen in diesem System.
    .do = Für ein anderes Koordinatensystem das Ergebnis transformieren: raybundle datum.

join-images_renamed = { $n } { $n ->
        [one] Bild
       *[other] Bilder
     } von { $name } { $n ->
        [one] hat einen neuen Namen
       *[other] haben neue Namen
     } wie { $example }: Die alten gibt es in einem anderen Block.
    .why = Namen sind in einem Block eindeutig; die Messungen ändern sich nicht.
    .do = In Tabellen und Optionen für den gemeinsamen Block die neuen Namen verwenden.

join-cameras_renamed = Kameras von { $name } gelten als andere Kameras: { LIST($ids, most: 9) } { $n ->
        [one] heißt
       *[other] heißen
     } jetzt { LIST($renamed, most: 9) }.
    .why = Im gemeinsamen Block hat jede Kamera ihre eigene innere Orientierung.
    .do = Wenn es dieselbe Kamera ist, { OPTION("same_camera", "True") } verwenden.

join-other_frame = { $name } ist in das System von { $base } transformiert, dessen Ursprung { NUM($away_m, decimals: 3) } m entfernt ist.
    .why = Das ursprüngliche System ist { $kind ->
        [projected] { $system }
        [geocentric] geozentrisch
       *[local] lokal{ $known ->
            [yes] { " " }in { $system }
           *[no] { " " }(geographische Länge, Breite, Höhe)
        }, Ursprung { $origin }
     }.
    .do = Für ein anderes Koordinatensystem das Ergebnis transformieren: raybundle datum.

join-point_incomplete = Punkt { $point } von { $block } fehlt eine Koordinate; er lässt sich nicht in das andere System überführen.
    .do = Den Block zuerst ausgleichen.

join-vertical_of_tables = Die Lotrichtungen der Systeme weichen um { NUM($tilt_deg, digits: 2) }° ab (Grenze { NUM($limit_deg, digits: 2) }°).
    .why = { $tables } von { $block } beziehen sich auf die Lotrichtung.
    .do = Beide Blöcke in Systemen mit demselben Ursprung angeben.

join-frames_differ = { $block } ({ $unit }) und { $other } ({ $other_unit }) sind in Systemen, die sich nicht ineinander überführen lassen.
    .do = Beide in ein Koordinatensystem in Metern überführen (convert in einen Block, { OPTION("crs") }). Oder bei einem Block unbekannter Lage [frame] in der block.toml löschen.

join-frame_projected = { $block } ist in Koordinaten von { $system }.

join-frame_geocentric = { $block } ist in einem geozentrischen System.

join-frame_local = { $block } ist in einem lokalen System bei { NUM($longitude_deg, decimals: 6) }° geographischer Länge, { NUM($latitude_deg, decimals: 6) }° Breite, { NUM($height_m, decimals: 3) } m.

join-frame_of_system = { $block } ist in einem lokalen System von { $system }.
    .why = Sein Ursprung ist { NUM($x_m, decimals: 3) }, { NUM($y_m, decimals: 3) }, { NUM($height_m, decimals: 3) } m{ $geoid ->
        [yes] {" "}(Geoid { $geoid_m } m über dem Ellipsoid)
       *[no] {""}
    }.

join-points_apart = { $name }: Punkte gleichen Namens liegen auseinander und bleiben zwei Punkte: { $points }.
    .why = Ein solcher Punkt hat sich bewegt oder ist ein anderer.
    .do = Prüfen Sie diese Punkte.

join-block = { $name }: { $frame ->
    [same] im selben System
    *[moved] transformiert über { $n } { $n ->
        [one] gemeinsamen Punkt
        *[other] gemeinsame Punkte
    }, Maßstab { NUM($scale, digits: 6) }, Koordinaten { NUM($rms, digits: 3) } { $unit } auseinander (quadratisches Mittel)
 }.
