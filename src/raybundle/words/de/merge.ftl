merge-no_block = blocks[{ $entry }] ist vom Typ { $kind }, kein Block.
    .do = Einen Ordner zuerst mit read_block lesen.

merge-prefer_no_mapping = prefer = { $value } ist keine Zuordnung.
    .do = Zum Beispiel prefer=dict(point=0) angeben.

merge-prefer_unknown = prefer: Der Eintrag { $name } = { $block } ist ungültig.
    .do = Eines von { LIST($known, most: 9) } und die Position eines der { $n } Blöcke ab 0 angeben.

merge-no_blocks = Es gibt keine Blöcke zum Zusammenführen.
    .do = Mindestens einen Block angeben.

merge-contradiction = { $name } ist { $value } in Block { $first } ({ $block }), { $other } in Block { $second } ({ $other_block }).
    .do = Einen der Werte korrigieren oder den Block wählen, der Vorrang hat: prefer=dict({ $subject }={ $first }).

merge-do_not_fit = Die Blöcke passen nicht zusammen: { $name }, { $entry }.
    .do = Diesen Eintrag in einem der Blöcke korrigieren.
