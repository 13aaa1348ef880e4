mask_uniform = Die { $n ->
        [one] Maske
       *[other] Masken
    } von { $n } { $n ->
        [one] Aufnahme verdeckt
       *[other] Aufnahmen verdecken
    } nichts: { LIST($ids, most: 3) }.
    .why = Eine Maske verdeckt, wo alle Kanäle 0 sind oder ein veränderlicher Alphakanal 0 ist.
    .do = Die Masken prüfen.

mask_uniform-hidden = { $n } { $n ->
        [one] Aufnahme ist durch ihre Maske
       *[other] Aufnahmen sind durch ihre Masken
    } ganz verdeckt: { LIST($ids, most: 3) }.
    .why = Dort wird nichts gemessen. Eine Maske verdeckt, wo alle Kanäle 0 sind oder ein veränderlicher Alphakanal 0 ist.
    .do = Prüfen, ob die Masken invertiert sind.
