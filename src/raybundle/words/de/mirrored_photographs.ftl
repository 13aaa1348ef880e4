mirrored_photographs = { $n } { $n ->
        [one] Aufnahme ist
        *[other] Aufnahmen sind
    } gegenüber den anderen gespiegelt und ausgelassen: { LIST($names, most: 3) }.
    .why = { $photograph } hat { $matches } Zuordnungen mit { $other }, wenn links und rechts vertauscht werden, und höchstens { $plain } wie gegeben.
    .do = In einem Bildprogramm links und rechts vertauschen oder die Dias von der anderen Seite scannen.

mirrored_photographs-possible = { $n } { $n ->
        [one] Aufnahme ist
        *[other] Aufnahmen sind
    } vielleicht gegenüber den anderen gespiegelt: { LIST($names, most: 3) }.
    .why = { $photograph } hat { $matches } Zuordnungen mit { $other }, wenn links und rechts vertauscht werden, und höchstens { $plain } wie gegeben. Ein symmetrisches Objekt erklärt das ebenso; sie werden deshalb nicht ausgelassen.
    .do = Die Aufnahmen mit dem Objekt vergleichen. Bei gespiegelten links und rechts vertauschen und neu rechnen.

mirrored_photographs-stored = { $n } { $n ->
        [one] Aufnahme ist
        *[other] Aufnahmen sind
    } laut EXIF-Orientierung gespiegelt gespeichert: { LIST($names, most: 3) }.
    .why = Gemessen wird in den Pixeln, wie sie gespeichert sind; das Objekt ist gespiegelt.
    .do = Die Aufnahmen seitenrichtig speichern.
