

plan-not_sharp = { $kind ->
        [sheet] Das formatfüllende Blatt
        [facade] Die Fassade für Stereopaare
        [turntable] Das Objekt auf dem Drehteller
       *[building] Das Bauwerk
     } in { $distance_m } m ist unscharf (scharf: { $near_m } bis { $far_m } m).
    .do = Auf diese Entfernung fokussieren ({ OPTION("focus") }) oder abblenden ({ OPTION("f_number") }).

plan-no_flat_sheet = Eine Aufnahmeliste zur Kalibrierung braucht ein ebenes Blatt oder eine Kalibriertafel.
    .do = sheet:BREITE,HÖHE oder eine Kalibriertafel angeben.

plan-no_footprint = Das Objekt hat keinen Grundriss: Von oben ist es eine Linie oder ein Punkt.
    .do = Ein Objekt mit einer Grundfläche angeben.

plan-ring_too_far = Der Ring der Standpunkte ist { $distance_m } m von den Wänden entfernt; verfügbar sind { $reach_m } m.
    .why = Standpunkte dürfen nicht näher als { $clearance_m } m sein ({ OPTION("clearance") }).
    .do = { $needed_m } m ({ OPTION("around") }) oder einen kleineren Mindestabstand angeben.

plan-height_not_shown = Die Höhe von { $height_m } m braucht im Hochformat { $distance_m } m Abstand; verfügbar sind { $reach_m } m.
    .do = Ein Objektiv mit c = { NUM($c_mm, digits: 2) } mm ({ OPTION("c") }), einen höheren Standpunkt ({ OPTION("eye") }) oder mehr Abstand ({ OPTION("around") }) verwenden.

plan-no_stereo_overlap = Seite { $side }: Die beiden Aufnahmen eines Paars aus { $distance_m } m überdecken sich nicht.
    .do = Ein Objektiv mit größerem Bildwinkel verwenden.

plan-stations_missing = Die Standpunkte der Aufnahmen fehlen; für sie werden Zielmarken verteilt.
    .do = { OPTION("stations", "plan/stations.csv") } angeben, wie raybundle plan network es schreibt.

plan-too_few_target_places = { $n } Stellen des Objekts sind von { $rays } der { $stations } Standpunkte sichtbar; Zielmarken brauchen 4.
    .do = Mehr Aufnahmen planen.

plan-targets_too_large = Zielmarken brauchen je { NUM($size_mm, decimals: 0) } mm; das Objekt hat für jede { NUM($space_mm, decimals: 0) } mm.
    .why = Die Punkte der Zielmarken haben { $across_px } px in der entferntesten Aufnahme.
    .do = Weniger Zielmarken ({ OPTION("count") }), nähere Standpunkte oder kleinere Punkte ({ OPTION("across") }) verwenden.

plan-turn_too_large = { $n } Schritte einer Drehung sind je { NUM($step_deg, decimals: 0) }°; benachbarte Aufnahmen überdecken sich zu wenig.
    .do = Mindestens 8 Schritte verwenden.

plan-no_place_for_bars = Keine zwei Objektpunkte mit freier Sicht zueinander haben { $length_m } m Abstand, die Länge einer Maßstabsstrecke.
    .why = Die entferntesten zwei haben { $longest_m } m.
    .do = Kürzere Maßstabsstrecken oder mehr Punkte verwenden.

plan-no_station_allowed = Keine von { $n } geprüften Positionen ist als Standpunkt erlaubt.
    .why = Objekt, Mindestabstand von { $clearance_m } m und verbotene Quader füllen den Raum von ({ $low }) bis ({ $high }) m.
    .do = Den Raum vergrößern oder den Mindestabstand verkleinern.

plan-object_not_seen = Keine von { $n } erlaubten Positionen sieht { $least } Objektpunkte.
    .why = Die Schärfentiefe beginnt bei { $near_m } m; Strahlen dürfen { $incidence_deg }° von der Normalen abweichen.
    .do = Mehr Abstand oder einen größeren Einfallswinkel zulassen.

plan-station_not_allowed = Standpunkt { $station } liegt außerhalb der Grenzen, zu nahe am Objekt oder in einem verbotenen Quader.
    .do = Den Standpunkt verlegen oder löschen.

plan-points_not_adjusted = { $n ->
        [0] Kein Punkt ist angegeben
       *[other] Punkte gehen nicht in die Ausgleichung ein: { $names }
     }.
    .do = Punkte angeben, die die Ausgleichung schätzt.

plan-camera_fixed = Kamera { $camera }: Kein Parameter wird geschätzt, also lässt sich keiner verbessern.
    .do = Die Kameraparameter in der Ausgleichung schätzen.

plan-too_few_control = { $n } Passpunkte legen kein Datum fest; nötig sind { $least }.
    .do = Mindestens { $least } Passpunkte planen.

plan-control_not_sufficient = { $n } Passpunkte bestimmen das Datum dieses Netzes nicht.
    .do = Mehr Passpunkte planen.

plan-mission_pattern = Die Genauigkeit einer Befliegung mit dem Muster { $pattern } lässt sich nicht vorhersagen.
    .why = Unbekannt ist, welche Teile des Objekts die Aufnahmen zeigen.
    .do = raybundle plan network mit der Form des Objekts verwenden.

plan-aim_no_sigma = Das Ziel { $aim } ist keine Standardabweichung.
    .do = Statt des gewünschten Werts die Anzahl der Standpunkte angeben.

plan-no_goal = Der Plan hat weder eine gewünschte Standardabweichung noch eine Anzahl der Standpunkte.
    .do = Eines von beiden angeben.

plan-points_rarely_found = Punkte dieser Art werden so selten gefunden, dass das Netz aus { $n } Standpunkten oft versagt.
    .why = Es versagt bei { PERCENT($share) } % der simulierten Messungen.
    .do = Mehr Standpunkte oder Punkte planen oder Zielmarken verwenden.

plan-nothing_seen_again = Keiner von { $n } möglichen Standpunkten sieht { $least } Punkte des Blocks.
    .do = Mehr Positionen ({ OPTION("step") }, { OPTION("around") }) oder einen größeren Winkel ({ OPTION("incidence") }) zulassen.

plan-too_few_candidates = { $n } mögliche Standpunkte sehen genug Punkte; verlangt sind { $wanted } Aufnahmen.
    .do = Weniger Aufnahmen verlangen: { OPTION("photographs") }.

plan-no_object_points = Die Ausgleichung hat keinen Objektpunkt, den eine Aufnahme zeigen könnte.
    .do = Einen Block mit Objektpunkten ausgleichen.

plan-unknown_camera = Der Block hat keine Kamera { $camera }.
    .do = Eine von { LIST($known, most: 10) } verwenden.

plan-no_frame_camera = Kamera { $camera } ({ $model }) ist keine Messkamera mit einzelnen Standpunkten.
    .why = Vorschläge brauchen einen Standpunkt je Aufnahme und eine gemeinsame innere Orientierung; Szenen, Rolling Shutter und Kameraverbünde haben das nicht.
    .do = Eine andere Kamera wählen.

plan-camera_not_used = Kamera { $camera } hat keine Aufnahme in der Ausgleichung.
    .do = Eine andere Kamera wählen.

plan-object_elsewhere = Objekt { $name }: Die Hälfte der Punkte liegt mehr als { $off } neben der Oberfläche (Grenze { $limit }).
    .do = Das Objekt im System und in der Längeneinheit des Blocks angeben.

plan-not_oriented = Block { $block } hat Aufnahmen ohne Orientierung.
    .do = Den Block zuerst orientieren oder ausgleichen.

plan-photograph_not_oriented = Aufnahme { $image } des Blocks { $block } hat keine Orientierung.
    .do = Den Block zuerst orientieren oder ausgleichen.

plan-no_common_interior = Kamera { $camera } hat keine gemeinsame innere Orientierung ihrer Aufnahmen.
    .do = Eine Kamera mit gemeinsamer innerer Orientierung wählen.

plan-no_station_within = Keiner von { $n } Standpunkten liegt innerhalb der Grenzen.
    .do = { OPTION("step") }, { OPTION("around") }, { OPTION("heights") }, { OPTION("clearance") } oder { OPTION("forbid") } erweitern.

plan-one_place = Aufnahmen vom selben Standpunkt lassen sich nicht mit der Liste vergleichen.
    .do = Prüfen, ob sie zu dieser Liste gehören.

plan-other_list = Die Standpunkte dieser Aufnahmen stimmen an höchstens { $n } von { $total } Stellen mit der Liste überein.
    .why = Die Standpunkte weichen um { NUM($off, decimals: 2) } der Objektentfernung ab (Grenze { NUM($limit, decimals: 2) }).
    .do = Prüfen, ob die Aufnahmen zu dieser Liste gehören.

plan-too_few_visible = { $n } von { $total } Objektpunkten sind von { $least } { $given ->
        [yes] der gegebenen Standpunkte
       *[no] möglichen Standpunkten
     } sichtbar.
    .do = Den Raum für Standpunkte erweitern oder größere Einfallswinkel zulassen.

plan-no_network_sees_all = Kein Netz mit bis zu { $most } Standpunkten sieht jeden Punkt { $least }-mal.
    .do = Den Raum für Standpunkte erweitern, die Zahl der Strahlen verringern oder die verdeckten Teile ausschließen.

plan-beyond_reach = Eine Standardabweichung von { $wanted_mm } mm ist nicht möglich: { $n } Standpunkte erreichen { $reached_mm } mm.
    .why = In der kleinsten Entfernung von { $near_m } m sind { $sigma_px } px { NUM($sigma_mm, digits: 2) } mm am Objekt.
    .do = Näher herangehen oder eine längere Brennweite oder genauere Zielmarken verwenden.

plan-station_sees_too_few = Standpunkt { $station } sieht { $n } von { $total } Objektpunkten; seine Orientierung braucht { $least }.
    .why = Das betrifft { $stations } von { $all_stations } Standpunkten.
    .do = { $given ->
        [yes] Prüfen, ob Standpunkte und Objekt dasselbe System haben
       *[no] Mehr Punkte, mehr Raum für Standpunkte oder ein Objektiv mit größerem Bildwinkel verwenden
     }.

plan-too_few_rays = Mit { $stations } Standpunkten haben { $n } von { $total } Objektpunkten weniger als { $least } Strahlen.
    .do = Mehr Standpunkte, mehr Raum für sie oder ein Objektiv mit größerem Bildwinkel planen.

plan-not_determined = Ein Netz aus { $stations } Standpunkten bestimmt nicht alle Unbekannten.
    .do = { $free ->
        [yes] Mehr Punkte oder Standpunkte planen oder die Kameraparameter festhalten
       *[no] Mehr Punkte oder Standpunkte planen
     }.

plan-list_count = Die Liste hat { $n } Aufnahmen, die Planung { $planned }.
    .do = Die Liste neu erzeugen.

plan-list_missing = Die gedruckte Liste fehlt.
    .do = Die Liste neu erzeugen.

plan-list_edges = Die Kanten des Objekts fehlen oder haben nicht je zwei Enden.
    .do = Die Liste neu erzeugen.

plan-station_at_itself = Ein Aufnahmestandpunkt hat sich selbst als Zielpunkt.
    .do = at_X, at_Y und at_Z dieses Standpunkts korrigieren.

plan-never_sharp = Aufnahmen sind ab { $near_m } m scharf; Aufnahmestandpunkte sind höchstens { $far_m } m entfernt.
    .do = { OPTION("f_number") } größer, { OPTION("focus") } anders oder { OPTION("around") } größer wählen.

plan-points_and_aim = { OPTION("points") } gehört zu { OPTION("aim", "worst") }.
    .do = Eines von beiden weglassen.

plan-no_improvement = Keine von { $n } möglichen Aufnahmestandpunkten senkt eine Standardabweichung.
    .why = Die Geometrie der Aufnahmen begrenzt die Genauigkeit nicht.
    .do = Passpunkte, Maßstabsstrecken oder genauere Bildmessungen ergänzen oder { OPTION("step") } oder { OPTION("around") } vergrößern.

plan-focus_without_scale = { OPTION("focus") } braucht den Maßstab des Blocks; er ist nicht bestimmt.
    .do = Es weglassen.

plan-unknown_list = Es gibt keine Liste der Art { $kind }.
    .do = Eine von { LIST($known, most: 20) } verwenden.

plan-point_missing = Punkt { $point } des Blocks der Planung fehlt.
    .do = Die Planung neu erzeugen.

plan-flight_too_large = Der Flug hat { $total } Aufnahmen; Vorhersagen sind bis { $most } möglich.
    .why = { $area ->
        [yes] { $lines } Linien mit { $photographs } Aufnahmen decken { NUM($width_m, digits: 6) } x { NUM($length_m, digits: 6) } m (Basis { $base_m } m, Linienabstand { $spacing_m } m)
       *[no] Angegeben sind { $lines } Linien mit { $photographs } Aufnahmen
     }.
    .do = Einen Teil mit derselben Basis und demselben Abstand vorhersagen: { $area ->
        [yes] { OPTION("area") }, { OPTION("gsd") }, { OPTION("overlap") }
       *[no] { OPTION("lines") }, { OPTION("photographs_per_line") }
     }.

plan-list_alike_turned = Die Liste sieht gedreht gleich aus: Aufnahmen sind nach ihrer Reihenfolge zugeordnet.
    .why = Bei anderer Reihenfolge kann das Fehlende auf einer anderen Seite liegen.

plan-list_most_beside = { $n } von { $of } Aufnahmen stehen nicht auf der Liste.
    .do = Prüfen Sie, ob die Aufnahmen zu dieser Liste gehören.

plan-list_most_missing = { $n } von { $of } Aufnahmen der Liste fehlen.
    .why = Wenige Aufnahmen passen zufällig zu vielen Stellen.
    .do = Prüfen Sie, ob die Aufnahmen zu dieser Liste gehören.

plan-nothing_lowers = { $n } von { $wanted } Aufnahmen sind vorgeschlagen: keine weitere in Reichweite senkt den Wert.

plan-hardly_lowers = Aufnahmen in Reichweite senken den Wert nur um { PERCENT($share) } %.
    .do = Fügen Sie Passpunkte, Maßstäbe oder genauere Bildpunkte hinzu, oder erlauben Sie andere Standpunkte ({ OPTION("step") }, { OPTION("around") }).

plan-points_out_of_sight = { $n } von { $of } Punkten sind von weniger als { $rays } möglichen Standpunkten sichtbar ({ $sides }).
    .why = Für sie wird keine Genauigkeit vorhergesagt.
    .do = Erlauben Sie mehr Standpunkte ({ OPTION("heights") }, { OPTION("clearance") }, { OPTION("incidence") }, { OPTION("around") }).

plan-object_between_points = { PERCENT($share) } % des Objekts, zwischen den Punkten, sehen weniger als zwei Aufnahmen.
    .do = Planen Sie mit mehr { OPTION("object_points") }.

plan-points_seldom_found = { PERCENT($share) } % der Punkte sind in weniger als zwei Aufnahmen zu erwarten.
    .why = Die Werte sind Mediane zufälliger Ziehungen; bei einer von zehn Aufnahmen erreicht der schlechteste Punkt { NUM($worst, digits: 2) } { $unit }.

plan-network_falls_apart = In { PERCENT($share) } % der zufälligen Ziehungen zerfällt das Netz.
    .do = Machen Sie mehr Aufnahmen.

plan-little_overlap = Die Längsüberdeckung beträgt { PERCENT($overlap) } %.
    .why = Unter 50 % werden Punkte zwischen den Aufnahmen eines Streifens nur einmal gesehen.
    .do = Planen Sie mindestens 60 % Längsüberdeckung.

plan-gaps_between_lines = Zwischen den Flugstreifen bleiben Lücken (Querüberdeckung { PERCENT($overlap) } %).
    .do = Planen Sie die Streifen näher beieinander.

plan-flown_apart = Genau wie geplant geflogen, hängen die Aufnahmen nicht zusammen.
    .why = Nachbarn haben einen zu schmalen Streifen gemeinsam.
    .do = Planen Sie mehr { OPTION("overlap") }.

plan-flown_lost = Genau wie geplant geflogen, sind Parameter nicht bestimmbar: { $parameters }.

plan-flown_calibrated = Keine geprüfte Änderung des Flugs bestimmt sie.
    .do = Halten Sie die Kamera fest, wie vor dem Flug kalibriert.

plan-free_camera = Gemessene Sigmas natürlicher Punkte waren { $low }- bis { $high }-mal die des Plans.
    .why = In vier Projekten, deren Kamera mit dem Objekt kalibriert wurde.
    .do = Halten Sie eine kalibrierte Kamera fest ({ OPTION("hold_camera") }), oder planen Sie mit diesem Spielraum.

plan-other_camera = Der Bildwinkel beträgt { NUM($seen_deg, decimals: 0) } Grad; geplant waren { NUM($planned_deg, decimals: 0) } Grad.
    .why = Objektiv, Zoom oder Ausschnitt des Formats weichen vom Plan ab.
    .do = Nehmen Sie mit der geplanten Kamera auf, oder planen Sie mit dieser.

plan-flight_undetermined = { $lost ->
        [yes] Dieser Flug bestimmt nicht: { $parameters }.
        *[no] Nur die Unregelmäßigkeit des Fluges bestimmt { $parameters }.
    }
    .why = { $lost ->
            [yes] Bei genau ebenem Flug in einer Höhe nicht bestimmt: { $level }.
            *[no] Ein genau ebener Flug in einer Höhe bestimmt sie nicht.
        }
    .do = { $remedy ->
            [none] { $hold ->
                [camera] Keine Änderung des Fluges hilft: die Kamera wie kalibriert festhalten ({ OPTION("hold_camera", "True") }).
                [lever_arm] Keine Änderung des Fluges hilft: den Hebelarm messen und festhalten.
                *[both] Keine Änderung hilft: Kamera ({ OPTION("hold_camera", "True") }) und gemessenen Hebelarm festhalten.
            }
            *[other] Den Plan ändern: { $remedy }. Sigma: { $figures }.
        }
