start_parallel = { $n } { $n ->
        [one] Punkt hat
       *[other] Punkte haben
     } in den Näherungswerten fast parallele Strahlen: { $ids }.
