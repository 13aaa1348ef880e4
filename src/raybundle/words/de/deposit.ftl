deposit-entries_missing = Im Aufnahmebogen fehlt, wonach Archive fragen: { LIST($names, most: 6) }.
    .do = Mit `raybundle record` nachtragen und das Paket noch einmal schreiben.

deposit-photographs_missing = { $n } { $n ->
        [one] Foto fehlt
       *[other] Fotos fehlen
    }: { LIST($names, most: 3) }.
    .do = Die Fotos in ihren Ordner zurückbringen und das Paket noch einmal schreiben.
