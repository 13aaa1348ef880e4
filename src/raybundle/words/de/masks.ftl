masks = { $n } von { $photographs } Aufnahmen haben eine Maske; { $of ->
        [features] Merkmale werden nur dort gesucht
       *[depths] Tiefen werden nur dort gemessen
    }, wo sie nicht schwarz ist.
    .why = { $missing ->
        [0] {""}
       *[other] Ohne Maske und ganz verwendet: { $missing } ({ LIST($ids, most: 3) }).
    }
