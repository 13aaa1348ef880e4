report_photographs-title = Aufnahmen

report_photographs-oriented = orientierte Aufnahmen

report_photographs-excluded = { $not_oriented ->
        [0] { $refused ->
            [0] alle verwendet
            *[other] {""}
        }
        *[other] { $not_oriented } ohne Orientierung{ $refused ->
            [0] {""}
            *[other] {", "}
        }
    }{ $refused ->
        [0] {""}
        [one] { $refused } Datei abgelehnt
        *[other] { $refused } Dateien abgelehnt
    }

report_photographs-names = { LIST($names, most: 3) }

report_photographs-mean_rays = mittlere Zahl der Strahlen: { NUM($mean, decimals: 1) }

report_photographs-image_point = gemessener Bildpunkt

report_photographs-image_point_meaning = Standardabweichung einer Koordinate (RMS), aus den Verbesserungen

report_photographs-count = { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    }

report_photographs-size = Größe [px]

report_photographs-taken = Datum

report_photographs-position = Position

report_photographs-in_three_images = in 3 Bildern oder mehr

report_photographs-neighbours = Nachbarn

report_photographs-rms_residual = Verbesserung, RMS

report_photographs-covered = Format abgedeckt

report_photographs-p_wrong = P(falsch)

report_photographs-p_wrong_note = P(falsch): Wahrscheinlichkeit, dass der Standpunkt falsch ist; hervorgehoben über { PERCENT($limit) } %.
    .why = Falsch: um mehr als 1 % der Ausdehnung oder 1°.

report_photographs-neighbours_note = Nachbarn: Aufnahmen mit { $least } gemeinsamen Punkten oder mehr.

report_photographs-covered_note = Format abgedeckt: Anteil der 10 × 10 Zellen mit einem Bildpunkt.

report_photographs-marked_note = Hervorgehoben: ohne Orientierung, ohne Nachbarn oder zu weniger als { PERCENT($share) } % abgedeckt.
    .why = Verzeichnung ist nur dort bestimmt, wo es Punkte gibt.

report_photographs-refused = abgelehnt

report_photographs-refused_remedy = Eine Kopie einer anderen Aufnahme löschen.
    .do = Sonst neu exportieren und den Befehl wiederholen.

report_photographs-not_oriented = nicht orientiert

report_photographs-not_oriented_remedy = Aufnahmen zwischen ihr und ihren Nachbarn ergänzen (mindestens 60 % Überdeckung) oder auf sie verzichten.

report_photographs-excluded_heading = Aufnahmen ohne Anteil am Ergebnis

report_photographs-matrix_cell = Eine Zelle steht für { $n } × { $n } Bilder und zeigt ihr stärkstes Paar.

report_photographs-graph = Bilder an ihren Projektionszentren, { $oblique ->
        [yes] auf der Ebene der größten Ausdehnung (die Achsen sind beliebig)
        *[no] Grundriss (XY)
    }.
    .why = Linien verbinden Bilder mit gemeinsamen Punkten, umso breiter, je mehr es sind: blau ab { $strong }, rostrot unter { $weak }.

report_photographs-matrix = Gemeinsame Punkte je zweier Bilder.

report_photographs-connections = Verbindungen zwischen den Aufnahmen

report_photographs-compared = verglichen

report_photographs-pairs_compared = { $n } { $n ->
        [one] Paar
        *[other] Paare
    } von Aufnahmen; { $fit } davon passen zusammen.

report_photographs-joined = verbunden

report_photographs-pairs_joined = { $n } { $n ->
        [one] Bildpaar hat
        *[other] Bildpaare haben
    } im Ergebnis gemeinsame Punkte.
    .why = Ein Bild hat { $median } Nachbarn (Median) mit { $least } gemeinsamen Punkten oder mehr.

report_photographs-weak = schwach

report_photographs-weak_photographs = Weniger als 2 Nachbarn mit { $least } gemeinsamen Punkten: { LIST($names, most: 8) }.
    .why = Ihre Orientierung hängt an einer einzigen Verbindung.
    .do = Aufnahmen von Positionen zwischen ihnen und den nächsten ergänzen.

report_photographs-loose = lose

report_photographs-loose_parts = Verbindungen mit { $least } gemeinsamen Punkten oder mehr ergeben { $n } getrennte Teile; zwischen ihnen sind es weniger.
    .do = Aufnahmen machen, die beide Seiten jeder Lücke zeigen.

report_photographs-geometry = { $kind ->
        [general] allgemein
        [planar] eben
        [rotation] Drehung
        [watermark] Wasserzeichen
        *[none] keine
    }

report_photographs-geometry_meaning = { $kind ->
        [general] verschiedene Positionen
        [planar] eine Ebene oder fast eine
        [rotation] Drehung auf der Stelle: keine Tiefe
        [watermark] gleiche Marken an gleicher Stelle: nicht verwendet
        *[none] keine Übereinstimmung
    }

report_photographs-geometry_label = Geometrie

report_photographs-matches = Zuordnungen (Median)

report_photographs-of_candidates = von Kandidaten

report_photographs-candidates = Kandidaten

report_photographs-verified = bestätigt

report_photographs-compared_pairs = { $n } { $n ->
        [one] verglichenes Paar
        *[other] verglichene Paare
    }

report_photographs-no_coordinates = Kein Objektpunkt hat Koordinaten: Es gibt keine Karte.

report_photographs-coverage = Abdeckung und Überdeckung

report_photographs-overlap = Die Hälfte der kartierten Fläche liegt in { $median } Bildern oder mehr; { PERCENT($share) } % davon in weniger als 3.

report_photographs-little_overlap = In weniger als 3 Bildern ist ein grober Fehler kaum zu sehen, und die Tiefe ist schwach.
    .do = Aufnahmen ergänzen, sodass jeder Teil von 3 Positionen oder mehr zu sehen ist.

report_photographs-ray_map = { $n } von { $of } Objektpunkten nach der Zahl ihrer Strahlen; { $oblique ->
        [yes] Ebene der größten Ausdehnung
        *[no] Grundriss (XY)
    }.

report_photographs-overlap_map = Zahl der Bilder mit einem Objektpunkt in jeder Zelle, auf derselben Karte.

report_photographs-start_differs = Der Schätzwert weicht um { NUM($ratio, decimals: 1) } Standardabweichungen vom Startwert ab.
    .why = Ursachen: Zoom oder Fokus verstellt, Aufnahmen beschnitten oder skaliert, oder ein ebenes Objekt frontal aufgenommen.

report_photographs-start_source = Herkunft des Startwerts

report_photographs-start_c = c, Startwert

report_photographs-estimated_c = c, geschätzt

report_photographs-change = Änderung

report_photographs-in_sigmas = in σ des Startwerts

report_photographs-c_note = c: Kammerkonstante in Pixelbreiten.

report_photographs-start = Kameras: Startwert und Schätzwert

report_photographs-stage = Schritt

report_photographs-processor_time = Prozessorzeit

report_photographs-memory = Speicher

report_photographs-stored = aus einem früheren Lauf

report_photographs-memory_note = Speicher: Maximum des Prozesses bis zum Ende des Schritts.
    .why = Die Zeit eines Schritts aus einem früheren Lauf ist die seines Einlesens.

report_photographs-all_stages = alle Schritte dieses Laufs

report_photographs-all_processors = alle Prozessoren

report_photographs-at_most = Maximum

report_photographs-processing = Zeit und Speicher

report_photographs-settings_note = Einstellungen, die von den Vorgaben abweichen, mit ihren Namen in project.toml und Python.

report_photographs-stage_name = { $name ->
        [photographs] Aufnahmen
        [known] bekannte Positionen
        [cameras] Kameras
        [features] Merkmale
        [matching] Zuordnung
        [start] Näherungswerte
        [precision] genaue Messung
        [targets] Zielmarken
        [adjustment] Ausgleichung
        [verdict] Urteil
        [recognised] erkannte Zielmarken
        [natural] natürliche Punkte
        *[other] { $other }
    }

report_photographs-recorded_position = { $fix ->
        [none] GNSS
        *[other] { $fix } GNSS
    }{ $sigma_m ->
        [0] {""}
        *[other] , σ { NUM($sigma_m, digits: 2) } m
    }
