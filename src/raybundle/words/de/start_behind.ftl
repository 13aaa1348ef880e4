start_behind = { $n } { $n ->
        [one] Punkt hat
       *[other] Punkte haben
     } in den Näherungswerten Strahlen, die sich hinter einer Kamera schneiden: { $ids }.
