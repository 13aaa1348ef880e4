target_sheet-printed = { $n } { $points ->
        [yes] Punkte
        *[no] Marken
    } von { $target } auf { $pages } { $pages ->
        [one] Seite
        *[other] Seiten
    } { $paper }{ $tiles ->
        [0] {""}
        *[other] , gedruckt als { $tiles } Seiten { $tile }
    }.

target_sheet-chosen = Gewählt: { $n } Marken von { $target }.

target_sheet-distinct = Unterscheidbar, wenn { $hidden } benachbarte von { $bits } Sektoren verdeckt sind; kleinster Abstand { $distance } Sektoren.

target_sheet-foot = { $target }, { $quantity ->
        [radius] Punktradius
        [spacing] Abstand
        *[side] Seite
    } { NUM($size_mm, digits: 6) } mm{ $page ->
        [0] {""}
        *[other] , Seite { $page }
    }; auf 100 % drucken

target_sheet-dots_foot = Punkte ohne Code, Radius { NUM($radius_mm, digits: 6) } mm; auf 100 % drucken

target_sheet-scale_bar = { NUM($length_mm, digits: 6) } mm vom ersten zum letzten Teilstrich: am Ausdruck messen

target_sheet-part = Spalte { $x }, Zeile { $y } von { $columns } x { $rows } ab unten links

target_sheet-overlap = (Teile überlappen um { NUM($overlap_mm, digits: 6) } mm; Kreuz auf Kreuz legen)
