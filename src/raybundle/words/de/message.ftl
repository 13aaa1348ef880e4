message-unknown_language = Meldungen in der Sprache { $language } gibt es nicht.
    .do = Eine von { $known } wählen.

message-unknown_code = Keine Meldung hat den Code { $code_name }.
    .do = Den Code in eckigen Klammern hinter der Meldung kopieren; ähnliche Codes: { $close }.
