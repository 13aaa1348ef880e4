measuring-oriented = { $n } von { $of } { $of ->
        [one] Aufnahme
        *[other] Aufnahmen
    } orientiert

measuring-next_step = { $kind ->
        [fiducials] { $image } braucht { $n } weitere { $n ->
            [one] Rahmenmarke
            *[other] Rahmenmarken
        }
        [film] Die Rahmenmarken von { $image } widersprechen einander
        [common] { $image } und { $other } brauchen { $n } { $n ->
            [one] weiteren gemeinsamen Punkt
            *[other] weitere gemeinsame Punkte
        }
        [base] { $image } und { $other } sind vom selben Ort aufgenommen
        [marks] { $image } hat keinen Punkt mit einer anderen Aufnahme gemeinsam
        [fit] Keine Orientierung passt zu den Punkten von { $image }
        *[points] { $image } braucht { $n } { $n ->
            [one] weiteren Punkt
            *[other] weitere Punkte
        }
    }

measuring-large_block = Ein Block mit { $n } Bildbeobachtungen wird nur auf Wunsch ausgeglichen.

measuring-not_adjusted = Die Aufnahmen sind orientiert, aber nicht ausgeglichen.
    .do = Messen Sie mehr Punkte.

measuring-interior_held = Die Punkte bestimmen die innere Orientierung nicht; ihre Näherungswerte sind fest.
    .do = Messen Sie mehr Punkte.

measuring-constant_open = Kamera { $camera }: die Punkte bestimmen ihre Konstante nicht; { NUM($c_px, decimals: 0) } px sind geraten.

measuring-constant_of_points = Kamera { $camera }: Konstante { NUM($c_px, decimals: 0) } px, Sigma { NUM($sigma_px, decimals: 0) } px, aus den Punkten allein.

measuring-suspect_fiducials = Scan { $image }: verdächtige Rahmenmarken: { $marks }.
    .do = Messen Sie sie neu.

measuring-outside_scan = erwartet bei { NUM($x, decimals: 0) }; { NUM($y, decimals: 0) }, außerhalb des Scans

measuring-nothing_found = nichts bei { NUM($x, decimals: 0) }; { NUM($y, decimals: 0) }:

measuring-file_lacks = { $kind ->
        [csv] Eine CSV-Datei von Punkten
        *[gcp_list] Eine gcp_list.txt
    } kann nicht alles Gemessene aufnehmen.
    .do = Ein Blockordner nimmt alles auf.

measuring-lost_thing = { $what ->
        [scale_bars] Maßstäbe: { $n }
        [lines] Linien: { $n }
        [datum] Koordinatensystem durch Punkte
        [rejections] verworfene Messungen: { $n }
        [names] neue Namen von Punkten des Blocks: { $n }
        [tie_points] Verknüpfungspunkte: { $n }
        [partial_points] Punkte ohne alle drei Koordinaten: { $n }
        [check_roles] Rolle von Kontrollpunkten, die als Passpunkte gelesen werden
        [point_sigmas] Standardabweichungen von Punkten
        *[mark_sigmas] Standardabweichungen von Messungen
    }

measuring-too_few_marks = { $n ->
        [0] in keinem
        *[other] nur in einem
    } { $oriented ->
        [yes] orientierten Bild
        *[no] Bild
    } gemessen

measuring-unmarked_point = { $role ->
        [check] Kontrollpunkt
        *[control] Passpunkt
    }, der in keinem { $oriented ->
        [yes] orientierten Bild
        *[no] Bild
    } gemessen ist

measuring-not_in_block = nicht im Block

measuring-point_left_out = Punkt { $point } ist weggelassen ({ $cause })

measuring-image_not_oriented = Das Bild ist nicht orientiert.

measuring-point_outside = Der Punkt liegt hinter dem Bild oder weit außerhalb seines Formats.

measuring-image_not_adjusted = Ein Bild nimmt an der Ausgleichung nicht teil: es gibt keine Kovarianz.

measuring-no_other_mark = Der Punkt ist in keinem anderen orientierten Bild gemessen.

measuring-ray_outside = Sein Strahl aus { $image } läuft in allen wahrscheinlichen Tiefen am Format vorbei.

measuring-seen_once = In einem Bild gemessen: die Tiefe ist unbekannt.

measuring-no_statistics = Die Ausgleichung lief ohne Statistik: es gibt keine Kovarianzen.

measuring-block_not_adjusted = Der Block ist nicht ausgeglichen: Orientierungen gelten als fehlerfrei.

measuring-expected_extent = Bei dieser Genauigkeit ist { NUM($extent, digits: 2) } von einer vollkommenen { $quantity ->
        [plane] Ebene
        *[line] Geraden
    } zu erwarten.

measuring-no_scale = Kein Maßstab ist bestimmt: der Wert hat keine Einheit, sein Sigma gilt innerhalb des Netzes.

measuring-free_datum = Das Datum ist frei: Sigma gilt innerhalb des Netzes.

measuring-minimal_datum = Sigma bezieht sich auf die wenigsten festen Koordinaten; in den Tabellen können es andere sein.

measuring-near_zero = Ein Abstand nahe seinem Sigma ist nicht normalverteilt.

measuring-masks_written = { $n } { $n ->
        [one] Maske ist
        *[other] Masken sind
    } geschrieben.

measuring-photographs_not_found = { $n } { $n ->
        [one] Foto liegt
        *[other] Fotos liegen
    } nicht am Ort, den das Projekt nennt: ohne Masken.
