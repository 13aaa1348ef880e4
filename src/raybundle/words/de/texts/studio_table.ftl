studio_table-table = Tabelle

studio_table-kind = { $kind ->
        [observations] Bildbeobachtungen
        [pairs] Bildpaare
        *[points] Punkte
    }

studio_table-filter = Nach Namen filtern

studio_table-rows = Zeilen: Pfeiltasten wählen eine, Eingabe öffnet sie

studio_table-count = { $n } { $n ->
        [one] Zeile
        *[other] Zeilen
    }

studio_table-sort = Nach { $name } sortieren

studio_table-largest_w = max |w|

studio_table-w = |w|

studio_table-x = x [px]

studio_table-y = y [px]

studio_table-vx = vx [px]

studio_table-vy = vy [px]

studio_table-redundancy = Redundanz

studio_table-other_image = anderes Bild

studio_table-base = Basis

studio_table-observation = Bildbeobachtung
