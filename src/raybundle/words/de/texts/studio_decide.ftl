studio_decide-parts = Entscheidungen

studio_decide-run = Lauf
    .title = Den Lauf aller Schritte zeigen

studio_decide-options = Optionen
    .title = Die Optionen der Ausgleichung zeigen

studio_decide-parameters = Parameter
    .title = Die Parameter der Kameras zeigen

studio_decide-select = Auswählen
    .title = Bildbeobachtungen über eine Grenze auswählen

studio_decide-compare = Vergleichen
    .title = Ausgleichungen vergleichen

studio_decide-calibration = Kalibrierung
    .title = Die Qualität der Kalibrierung zeigen

studio_decide-targets = Zielmarken
    .title = Die Zielmarken der Aufnahmen zeigen

studio_decide-command = Dasselbe auf der Befehlszeile

studio_decide-reset = Vorgaben
    .title = Alle auf ihre Vorgaben setzen

studio_decide-adjust = Mit diesen Optionen ausgleichen
    .title = Den Bildverband mit den Bildmessungen im Hintergrund ausgleichen

studio_decide-options_note = Die Optionen gelten für jede Ausgleichung, die in diesem Studio beginnt.
    .why = Die Zeile unten zeigt den Fortschritt; Anhalten beendet die Ausgleichung und ändert nichts.

studio_decide-options_stored = Optionen der nächsten Ausgleichung gespeichert.

studio_decide-parameters_note = auto: nach Bildverband und Optionen; frei und fest gehen beiden vor.
    .why = Eine Wahl ist eine Aktion des Protokolls, die sich rückgängig machen lässt; sie gilt ab der nächsten Ausgleichung.

studio_decide-interiors_shown = { $n } von { $of } inneren Orientierungen sind gezeigt.

studio_decide-camera = Kamera { $camera }

studio_decide-camera_image = Kamera { $camera }, Bild { $image }

studio_decide-parameters_of = Parameter von { $name }

studio_decide-joint_tests = Gemeinsame Tests von Gruppen

studio_decide-joint_test = { $group }: F { $F }, p { $p }

studio_decide-next = nächste
    .title = In den nächsten Ausgleichungen

studio_decide-last_status = Status
    .title = In der letzten Ausgleichung

studio_decide-sigma = Sigma
    .title = Standardabweichung a posteriori

studio_decide-t = t
    .title = Wert durch seine Standardabweichung; bei zusätzlichen Parametern die Signifikanz

studio_decide-p = p
    .title = Wahrscheinlichkeit eines größeren |t| durch Zufall: klein heißt signifikant

studio_decide-effect = Wirkung [px]
    .title = Größte Verschiebung im Format durch den Wert

studio_decide-effect_sigma = ± [px]
    .title = Dasselbe für eine Standardabweichung

studio_decide-correlation = Korrelation
    .title = Die größte, mit einem anderen Parameter oder mit der äußeren Orientierung

studio_decide-correlated = korreliert mit { $other }

studio_decide-exterior = äußere Orientierung

studio_decide-strong = Über { $strong }: Die beiden sind kaum trennbar

studio_decide-status = { $status ->
        [held] festgehalten
        [estimated] geschätzt
        [observed] beobachtet
        [not_significant] nicht signifikant
        [not_determinable] nicht bestimmbar
        [not_adjusted] nicht ausgeglichen
        *[other] { $status }
    }

studio_decide-choice = { $choice ->
        [free] frei
        [held] fest
        *[auto] auto
    }

studio_decide-choice_of = { $symbol } der Kamera { $camera } in den nächsten Ausgleichungen

studio_decide-choice_stored = { $symbol } von { $camera }: { studio_decide-choice } ab der nächsten Ausgleichung.

studio_decide-limit = Grenze

studio_decide-observations_by = Bildbeobachtungen nach

studio_decide-beyond = Beobachtungen jenseits der Grenze

studio_decide-quantity = { $quantity ->
        [w] |w|
        [sigma] Sigma XYZ
        [rays] Strahlen
        *[redundancy] Redundanzanteil
    }

studio_decide-quantity_meaning = { $quantity ->
        [w] Größtes |w| einer Bildbeobachtung.
        [sigma] Größte Standardabweichung von X, Y, Z eines Verknüpfungspunkts.
        [rays] Verwendete Strahlen eines Verknüpfungspunkts.
        *[redundancy] Kleinerer Redundanzanteil einer Bildbeobachtung.
    }

studio_decide-range = Bereich { $low } bis { $high }, Median { $middle }.

studio_decide-no_range = Unbekannt: Die Ausgleichung hat keine Statistik.

studio_decide-selected = { $side ->
        [above] Ausgewählt sind Werte über der Grenze.
        *[below] Ausgewählt sind Werte unter der Grenze.
    }

studio_decide-counts = { $n } { $n ->
        [one] Bildbeobachtung
        *[other] Bildbeobachtungen
    } von { $points } { $points ->
        [one] Punkt
        *[other] Punkten
    } jenseits der Grenze: { $percent } % von { $used }.

studio_decide-marks_beyond = { $n } { $n ->
        [one] Bildmessung
        *[other] Bildmessungen
    } jenseits der Grenze; sie werden hier nicht verworfen.
    .do = Sie verschieben oder entfernen.

studio_decide-more = und { $n } weitere{ $drawn ->
        [some] ; nicht alle sind gezeichnet
        *[all] {""}
    }

studio_decide-reject_all = Alle verwerfen
    .title = Sie in einer Aktion verwerfen; einmal rückgängig stellt sie wieder her

studio_decide-rejected = Verworfen: jenseits von { $limit } in { studio_decide-quantity }.
    .do = Neu ausgleichen.

studio_decide-show_in_images = In Bildern zeigen
    .title = Ringe um die ausgewählten Bildpunkte zeichnen

studio_decide-show_in_space = Im Raum zeigen
    .title = Die ausgewählten Objektpunkte zeigen

studio_decide-draw = in Bildern und im Raum zeichnen

studio_decide-point_in_image = { $point } in { $image }

studio_decide-show_point = { $point } in { $image } zeigen

studio_decide-adjustments = Ausgleichungen dieser Sitzung

studio_decide-adjustment = Ausgleichung

studio_decide-first = erste

studio_decide-second = zweite

studio_decide-as_side = { $name } als { $side ->
        [first] erste
        *[second] zweite
    }

studio_decide-sigma0 = Sigma0

studio_decide-free = frei
    .title = Anzahl geschätzter Parameter

studio_decide-mean_sigma = mittleres Sigma

studio_decide-rms_check = RMS der Kontrollpunkte

studio_decide-defaults = Vorgaben

studio_decide-adjust_again = Zum Vergleichen mit einer anderen Option oder einem anderen Parameter neu ausgleichen.

studio_decide-choose_two = Zwei verschiedene Ausgleichungen wählen.

studio_decide-comparison = Vergleich der beiden Ausgleichungen

studio_decide-largest_residuals = Größte Verbesserungen von { $name }

studio_decide-v = v [px]

studio_decide-origin = { $origin ->
        [opened] anfängliches Ergebnis
        [before] früher gemessen
        [oriented] hier orientiert
        [calibrated] hier kalibriert
        [elsewhere] von einem anderen Programm geschrieben
        *[adjusted] hier ausgeglichen
    }

studio_decide-of_adjustment = der Ausgleichung

studio_decide-report = Bericht der Ausgleichung

studio_decide-not_adjusted = Noch nichts ist ausgeglichen: Ausgleichen drücken.

studio_decide-no_report = Dieses Ergebnis hat keinen Bericht: Ausgleichen drücken, um einen zu schreiben.

studio_decide-window = In einem Fenster öffnen

studio_decide-network = Netz in drei Dimensionen

studio_decide-judging = Die Qualität der Kalibrierung wird berechnet …

studio_decide-wait = Es gibt noch keine Ausgleichung.
    .do = Ihr Ende abwarten.

studio_decide-no_interior = Keine Kamera hat eine eigene ausgeglichene innere Orientierung.

studio_decide-no_verdict = Kein Parameter ist geschätzt: Es gibt kein Urteil.

studio_decide-verdict_source = { $source ->
        [stored] Von raybundle calibrate, mit Kreuzvalidierung.
        *[computed] Aus der letzten Ausgleichung, ohne Kreuzvalidierung (raybundle calibrate ergänzt sie).
    }

studio_decide-weaknesses = Schwächen

studio_decide-next_photographs = Nächste Aufnahmen

studio_decide-next_photographs_of = Nächste Aufnahmen mit Kamera { $camera }

studio_decide-uncertainty_then = Unsicherheit danach [px]

studio_decide-smaller_by = kleiner um

studio_decide-next_photographs_note = Größte Unsicherheit der Abbildung über das Format, jetzt { $now_px } px.
    .why = Jede Zeile zählt diese Aufnahme und die davor.
    .do = Die Aufnahmen machen und erneut laufen lassen.

studio_decide-no_next_photographs = Vier weitere Aufnahmen verbessern sie um weniger als ein Zehntel.

studio_decide-determinability = Bestimmbarkeit

studio_decide-largest_uncertainty = größte Unsicherheit der Abbildung

studio_decide-median_uncertainty = ihr Median über das Format

studio_decide-image_sigma = Bildpunkte

studio_decide-coverage = Format bedeckt

studio_decide-reach = Reichweite zu den Ecken

studio_decide-quarter_turns = Vierteldrehungen um die Achse

studio_decide-convergence = Achsen innerhalb, um ihr Mittel

studio_decide-cross_validation = { $rms_px } px weggelassen, { $fit_px } px in der Anpassung

studio_decide-about = Modell { $model }, { $width_px } × { $height_px } px, Pixel { NUM($pixel_um, digits: 4) } µm

studio_decide-coverage_caption = Verwendete Bildpunkte aller Aufnahmen, in jeder Zelle des Formats.

studio_decide-coverage_of = Bildpunkte der Kamera { $camera } über das Format
