ring_table-bits = Ein Ring mit { $bits } Bit ist nicht möglich.
    .do = 3 bis { $most } Bit angeben.

ring_table-row = { $value } ist keine Nummer mit einem Code.
    .do = Zwei ganze Zahlen schreiben.

ring_table-code_out_of_range = Der Code { $ring } liegt nicht zwischen 1 und { $largest }.
    .do = Den Code oder die Zahl der Bits korrigieren.

ring_table-empty = Die Tabelle enthält keine Zielmarke.
    .do = Eine Zielmarke je Zeile schreiben: ihre Nummer und ihren Code.

ring_table-ring_radii = Ein Ring von { $inner } bis { $outer } Punktradien hat keinen Abstand zum Punkt.
    .do = Einen Innenradius von mindestens 1,2 und einen größeren Außenradius angeben.

ring_table-id_twice = Die Nummer { $id } kommt zweimal vor.
    .do = Eine der beiden Zeilen löschen.

ring_table-ring_twice = Der Ring des Codes { $ring } gehört schon zur Nummer { $id }.
    .do = Den Code korrigieren oder die Zeile löschen.
