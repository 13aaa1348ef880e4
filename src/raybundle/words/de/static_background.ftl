static_background = In { $n } Aufnahmen liegen { PERCENT($share) } % der Zuordnungen in denselben Pixeln, während andere sich bewegen.
    .why = Ein Hintergrund, Wasserzeichen oder eingeblendetes Datum dreht sich nicht mit dem Objekt; das Ergebnis folgt einem von beiden.
    .do = { $masked ->
     [yes] Die Masken auf alles davon ausdehnen oder vor einem Hintergrund ohne Textur aufnehmen
     *[no] Den Hintergrund mit { OPTION("masks", "DIR") } maskieren oder vor einem Hintergrund ohne Textur aufnehmen
    }.
