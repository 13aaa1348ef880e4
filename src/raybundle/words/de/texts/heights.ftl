heights-scale_free = Der Maßstab ist frei: Längen haben keine Einheit.

heights-contours = Höhenlinien: { $lines } { $lines ->
        [one] Linie
        *[other] Linien
    } in { $n } { $n ->
        [one] Höhe
        *[other] Höhen
    }, { NUM($low, digits: 6) } bis { NUM($high, digits: 6) } { $unit }.

heights-ground = Gelände: { PERCENT($share) } % der Höhen liegen auf Objekten und wurden entfernt.

heights-gaps = Sigma im Median: gemessen { NUM($sigma, digits: 2) } { $unit }, über Lücken ({ PERCENT($share) } %) { NUM($sigma_gaps, digits: 2) } { $unit }.

heights-section_without_heights = { $name }: Länge { $length }, keine Höhen.

heights-section = { $name }: Länge { $length }, mittlere Höhe { $mean }.

heights-section_precision = { $name }: Höhen auf { PERCENT($share, digits: 3) } %, Sigma einer Stelle { $sigma } (Median).

heights-section_filled = { $name }: { PERCENT($share, digits: 3) } % der Höhen sind ergänzt, nicht gemessen.

heights-section_difference = { $name }: Höhenunterschied { $difference }.

heights-volume = Volumen über der Bezugsfläche ({ $base ->
        [rim] Ebene entlang des Umrisses
        *[other] { $base }
    }): { $above }; darunter: { $below }.

heights-net_volume = Nettovolumen: { $net }.

heights-volume_sigma = Sigma des Nettovolumens: lokale Fehler { $local }, Orientierung { $orientation }.

heights-mean_height = Mittlere Höhe über der Bezugsfläche: { $mean }.

heights-area = Fläche im Grundriss: { $area }; wahre Fläche: { $true_area }.

heights-volume_filled = { PERCENT($share, digits: 3) } % der Fläche wurden ergänzt (Sigma des Nettovolumens dadurch { $sigma }).

heights-moved = { $n ->
        [0] Kein Bereich hat sich gegen den Rest bewegt
        [one] 1 Bereich hat sich gegen den Rest bewegt
        *[other] { $n } Bereiche haben sich gegen den Rest bewegt
    } (Grenze { $limit } Sigma, Irrtumswahrscheinlichkeit 5 %).

heights-level_of_detection = Nachweisgrenze (Macht 80 %): { $amount } { $unit } auf { $side } x { $side } { $unit }{ $all_places ->
        [yes] {" "}(Median)
        *[no] , nur im besten Viertel
    }.

heights-no_movement_detectable = Nachweisgrenze: nicht bekannt (zu wenige Höhen, oder alle an Stufen).

heights-whole = Bewegung des Ganzen: Verschiebung { $shift }, { $significant ->
        [yes] signifikant
        *[no] nicht signifikant
    } (Chi² { $chi2 }, Grenze { $limit }).

heights-tilts = Neigungen des Ganzen: { $tilts }.

heights-compared = { PERCENT($share, digits: 3) } % der Höhen davor haben eine danach.

heights-same_measurement = { PERCENT($share, digits: 4) } % der Höhen sind in beiden dieselbe Messung: unbewegt, nicht getestet.

heights-region = Bereich { $k }: im Mittel { $mean }, Fläche { $area }, Volumen { $volume }.

heights-region_inner = Bereich { $k }: innerer Teil { $amount }, { $times } Sigma; stärkstes Fenster { $peak } Sigma.

heights-smallest = Kleinste nachweisbare Bewegung auf { $side } x { $side }: { $median ->
        [yes] { NUM($amount, digits: 2) } (Median)
        *[no] nicht bekannt (Median)
    }, { NUM($best, digits: 2) } { $unit } (bestes Viertel).

heights-one_adjustment = Beide Oberflächen stammen aus einer Ausgleichung. { $common ->
        [known] Gemeinsame Fehler der Orientierung heben sich auf.
        *[unknown] Ihre Orientierungen gelten als unabhängig.
    }

heights-same_frame = Beide Oberflächen brauchen einen Rahmen: dieselben Passpunkte oder gemeinsame stabile Punkte.

heights-changed_values = { $name } hat andere Werte als geschrieben wurden.
    .why = Die Standardabweichungen gelten für die Werte davor.

heights-adjusted_since = { $name } wurde nach der Messung dieser Oberfläche erneut ausgeglichen.
    .do = raybundle surface { $name }

heights-series = { $n } von { $total } Volumenänderungen sind signifikant (Irrtumswahrscheinlichkeit aller { PERCENT($significance) } %).

heights-series_region = { $name }: { $volume }; seit { $start } { $significant ->
        [yes] { $change }
        *[no] { $parts ->
            [none] keine signifikante Änderung
            [fill] keine signifikante Nettoänderung; Auftrag { $fill } signifikant
            [cut] keine signifikante Nettoänderung; Abtrag { $cut } signifikant
            *[both] keine signifikante Nettoänderung; Auftrag { $fill }, Abtrag { $cut } signifikant
        }
    }, nachweisbar { $detectable }{ $unit ->
        [none] {""}
        *[other] {" "}{ $unit }3
    }.

heights-series_change = { $name }, { $start } bis { $end }: { $significant ->
        [yes] { $change }
        *[no] { $parts ->
            [none] keine signifikante Änderung
            [fill] keine signifikante Nettoänderung; Auftrag { $fill } signifikant
            [cut] keine signifikante Nettoänderung; Abtrag { $cut } signifikant
            *[both] keine signifikante Nettoänderung; Auftrag { $fill }, Abtrag { $cut } signifikant
        }
    }, nachweisbar { $detectable }{ $unit ->
        [none] {""}
        *[other] {" "}{ $unit }3
    }.

heights-series_parts = { $name }, { $start } bis { $end }: Auftrag { $fill }, Abtrag { $cut }.

heights-series_rate = { $name }: im Mittel { $rate } am Tag; gleichmäßig: { P($p) }.

heights-series_orientations = { $common ->
        [known] Alle Tage stammen aus einer Ausgleichung: ihre gemeinsamen Fehler zählen einmal.
        [unknown] Alle Tage stammen aus einer Ausgleichung, ihre Orientierungen gelten aber als unabhängig.
        *[independent] Die Orientierungen der Tage gelten als unabhängig; gleiche Passpunkte machen Änderungen genauer.
    }

heights-aligned = Anderes Modell eingepasst über { PERCENT($share) } % der Höhen: Höhe { $up }.

heights-aligned_plan = Verschiebung des anderen Modells in der Lage: rechts { $right }, oben { $above }.

heights-aligned_tilts = Neigungen des anderen Modells: { $tilts }.

heights-noise_estimated = Rauschen des anderen Modells (geschätzt): { NUM($sigma, digits: 2) } { $unit }, davon { NUM($common, digits: 2) } { $unit } über { NUM($cells, digits: 2) } Zellen.
