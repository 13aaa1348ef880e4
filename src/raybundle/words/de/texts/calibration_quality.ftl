calibration_quality-grade = { $grade ->
        [good] gut
        [usable] brauchbar
        [weak] schwach
        *[not_determinable] nicht bestimmbar
    }

calibration_quality-camera_grade = Kamera { $camera }: { $grade ->
        [good] gut
        [usable] brauchbar
        [weak] schwach
        *[not_determinable] nicht bestimmbar
    }

calibration_quality-of_camera = Kamera { $camera }:

calibration_quality-title = Qualität der Kalibrierung

calibration_quality-limits = Grenzen dieses Urteils

calibration_quality-weaknesses = Schwächen

calibration_quality-stability = Stabilität

calibration_quality-same_setting = Zoom, Fokus, Stabilisierung und Temperatur verändern ein Objektiv. Mit den späteren Einstellungen kalibrieren.

calibration_quality-edge = Rand des Formats

calibration_quality-extrapolated = Außerhalb des äußersten Bildpunkts ist die Verzeichnung extrapoliert, ihr σ zu klein.

calibration_quality-head_not_determinable = Nicht bestimmbar: { $whole ->
        [yes] die innere Orientierung
        *[no] { LIST($names, most: 8) }
    }.
    .do = Diese Kalibrierung nicht für andere Aufnahmen verwenden; zuerst die vorgeschlagenen Aufnahmen machen.

calibration_quality-head_figures = Abbildungsfehler { NUM($typical_px, digits: 2) } px (Median; größter { NUM($largest_px, digits: 2) }), Bildpunkte { NUM($sigma_px, digits: 2) } px.

calibration_quality-head_weak = Schwach: nur als Näherung verwenden.
    .do = Die Kamera in jeder Ausgleichung neu schätzen.

calibration_quality-head_part = Gültig bis { PERCENT($reach) } % des Abstands zu den Ecken.

calibration_quality-head_inside = Gut bis { PERCENT($reach) } % des Abstands zu den Ecken ({ NUM($inside_px, digits: 2) } px), außerhalb brauchbar.
    .do = Punkte in den Ecken messen.

calibration_quality-head_usable = Brauchbar für Messungen bis etwa { NUM($px, digits: 2) } px.

calibration_quality-head_good = Gut: darf für Messungen bis { NUM($px, digits: 2) } px festgehalten werden.

calibration_quality-not_determinable = { $symbol } ist nicht bestimmbar und wird festgehalten{ $known ->
        [yes] {" "}(Standardabweichung { NUM($std, digits: 2) } { $unit })
        *[no] {""}
    }.

calibration_quality-few_photographs = { $n } Aufnahmen sind wenige; eine Kalibrierung braucht { $least } bis 20.

calibration_quality-uncertain = Größter Fehler über das Format: { NUM($sure_px, digits: 2) } px (Sicherheit { PERCENT($certainty) } %; zu erwarten { NUM($likely_px, digits: 2) } px).
    .do = { $unstable ->
            [yes] {""}
            *[no] Mehr konvergente und gerollte Aufnahmen machen oder Bildpunkte genauer messen.
        }

calibration_quality-reach = Bildpunkte reichen bis { PERCENT($reach) } % des Abstands zu den Ecken; die Verzeichnung außerhalb ist extrapoliert.

calibration_quality-coverage = Bildpunkte bedecken { PERCENT($coverage) } % des Formats.

calibration_quality-not_rolled = Keine Aufnahme ist um 90° um die Kameraachse gerollt.
    .why = Bildhauptpunkt und tangentiale Verzeichnung sind mit den Orientierungen korreliert.

calibration_quality-no_convergence = Die Kameraachsen konvergieren kaum: alle innerhalb von { NUM($angle_deg, digits: 2) }° um ihr Mittel.

calibration_quality-coupled = { $symbol } ist mit { $other ->
        [station] dem Standpunkt in Richtung der Kameraachse
        *[other] { $other }
    } korreliert ({ NUM($correlation, decimals: 2) }).

calibration_quality-contradicted = Weggelassene Aufnahmen weichen { NUM($excess, digits: 2) }-mal so weit ab wie vorhergesagt.
    .why = Die Kalibrierung gilt nicht für andere Aufnahmen.
    .do = Prüfen, ob die Kamera in allen Aufnahmen dieselbe und das Objekt stabil war.

calibration_quality-few_views = Zu wenige Ansichten: Weggelassene Aufnahmen passen { NUM($ratio, digits: 2) }-mal schlechter, wie vorhergesagt.
    .do = Dieselben Punkte öfter aufnehmen.

calibration_quality-structure = Benachbarte Verbesserungen sind korreliert ({ NUM($correlation, decimals: 2) }): Das Modell ist unvollständig.
    .why = Die Standardabweichungen sind mindestens um den Faktor { NUM($factor, digits: 2) } zu klein.

calibration_quality-repeated = Verbesserungen wiederholen sich am selben Bildort (Korrelation { NUM($correlation, decimals: 2) }, { NUM($rms_px, digits: 2) } px).
    .why = Das Verzeichnungsmodell ist unvollständig; die Standardabweichungen enthalten diesen Fehler nicht.

calibration_quality-largest_error = Größter Fehler über das Format: zu erwarten { NUM($likely_px, digits: 2) } px; { NUM($worst_px, digits: 2) } px mit 95 % Sicherheit.

calibration_quality-image_sigma = Standardabweichung einer Koordinate mittleren Gewichts, aus den Verbesserungen

calibration_quality-no_validation = zu wenige Aufnahmen

calibration_quality-validation = Verbesserungen weggelassener Aufnahmen ({ NUM($rms_px, digits: 2) } px) zu denen der übrigen, { $folds } Gruppen.

calibration_quality-farther = Sie weichen { NUM($excess, digits: 2) }-mal so weit ab wie vorhergesagt.

calibration_quality-as_predicted = Sie weichen ab wie vorhergesagt{ $unstable ->
        [yes] , doch die Vorhersage ist zu ungenau, um eine stabile Kamera zu zeigen
        *[no] {""}
    }.

calibration_quality-covered = von Bildpunkten bedeckt; sie reichen bis { PERCENT($reach) } % des Abstands zu den Ecken

calibration_quality-views = { $rolls } von 4 Vierteldrehungen um die Achse; Achsen innerhalb von { NUM($angle_deg, digits: 2) }° um ihr Mittel

calibration_quality-unstable = Mehr Aufnahmen einer Kamera, die sich ändert, helfen nicht.
    .do = Fokus, Zoom und Stabilisierung feststellen und neu aufnehmen, oder { OPTION("own_camera") } verwenden.

calibration_quality-no_advice = Vier weitere Aufnahmen verbessern sie um weniger als ein Zehntel.

calibration_quality-photograph_next = Nächste Aufnahmen

calibration_quality-photographs_in_order = Aufnahmen, in dieser Reihenfolge

calibration_quality-uncertainty_now = Unsicherheit jetzt

calibration_quality-uncertainty_then = danach

calibration_quality-smaller_by = kleiner um

calibration_quality-predicted = Größte vorhergesagte Unsicherheit über das Format mit diesen Aufnahmen, jetzt { NUM($now_px, digits: 2) } px.

calibration_quality-predicted_of_open = Größte vorhergesagte Unsicherheit über das Format mit diesen Aufnahmen; jetzt nicht bestimmbar.

calibration_quality-calibrate_again = Die Aufnahmen machen und erneut kalibrieren.

calibration_quality-station = Standpunkt in Richtung der Kameraachse

calibration_quality-coupled_with = korreliert mit

calibration_quality-coupling_effect = Korrelierte Parameter stören die Punkte dieses Netzes nicht, wohl aber andere Aufnahmen.
