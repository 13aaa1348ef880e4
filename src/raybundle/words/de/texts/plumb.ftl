plumb-block = Z des Bildverbands

plumb-block_found = Z des Bildverbands, { $by ->
        [edges] nach { $edges } lotrechten { $edges ->
            [one] Kante
            *[other] Kanten
        } in den Aufnahmen
        [given] wie angegeben
        *[held] nach der Haltung der Kamera
    }{ $known ->
        [yes] , ± { NUM($sigma_deg, digits: 2) } Grad
        *[no] {""}
    }

plumb-block_observed = Z des Bildverbands, nach { $lines ->
        [0] {""}
        [one] { $lines } gemessenen Lot
        *[other] { $lines } gemessenen Loten
    }{ $lines ->
        [0] {""}
        *[other] { $levels ->
            [0] {""}
            *[other] {" "}und{" "}
        }
    }{ $levels ->
        [0] {""}
        [one] { $levels } Waagerechten
        *[other] { $levels } Waagerechten
    }

plumb-lines = { $n } { $n ->
        [one] gemessenes Lot
        *[other] gemessene Lote
    }

plumb-points = von { $lower } bis { $upper }

plumb-lean = seine Punkte neigen sich { $back ->
        [yes] nach hinten
        *[no] nach vorn
    } um { NUM($lean_deg, digits: 2) }{ $sigma_known ->
        [yes] {" "}± { NUM($sigma_deg, digits: 2) }
        *[no] {""}
    } Grad
