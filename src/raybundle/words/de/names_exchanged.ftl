names_exchanged = { $pairs } { $pairs ->
        [one] Paar verworfener Bildpunkte passt
       *[other] Paare verworfener Bildpunkte passen
     } mit vertauschten Namen: { $ids }.
    .do = In diesen Bildern die Namen vertauschen.

names_exchanged-pair = Die Namen { $first } und { $second } sind im Bild { $image } wohl vertauscht.
