action-unknown_verb = Das Verb { $verb } ist unbekannt.
    .do = Eines von { LIST($known, most: 30) } verwenden.

action-unknown_argument = { $verb }: Das Argument { $name } ist unbekannt.
    .do = { LIST($known, most: 30) } verwenden.

action-arguments = { $verb }: Die Argumente sind ungültig ({ $detail }).
    .do = Die Argumente wie dokumentiert angeben.
