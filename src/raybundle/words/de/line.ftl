line-too_few_words = Wörter dieser Zeile: { $n }; nötig: { $needed }, am Ende { $columns }.
    .do = Die Zeile vervollständigen.

line-unprintable = Die Zeile enthält nicht druckbare Zeichen.
    .do = Diese Zeichen löschen.

line-ends_early = Die Zeile endet zu früh.
    .do = Die Zeile vervollständigen.

line-words_left = Überzählige Wörter am Zeilenende: { $n }.
    .do = Diese Wörter löschen.

line-too_few_cells = Spalten dieser Zeile: { $n }; nötig: { $needed }.
    .do = Die Zeile vervollständigen.
