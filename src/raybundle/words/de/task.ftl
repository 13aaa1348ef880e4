task-cycle = { $n } Aufgaben hängen voneinander ab: { $names }.
    .do = Bei eigenen Aufgaben eine Abhängigkeit entfernen, sonst diesen Fehler den Entwicklern melden.

task-shards_waiting = { $n } { $n ->
        [one] Aufgabe wartet
       *[other] Aufgaben warten
     } auf Teile (shards), in { $file_name }.
    .do = raybundle worker { OPTION("shard", "I/N") } { $project } für jedes I von 0 bis N - 1 in beliebiger Folge ausführen, dann denselben Befehl erneut.

task-list_not_readable = Die Aufgabenliste ist nicht lesbar ({ $detail }).
    .do = Die Zugriffsrechte der Datei prüfen.

task-list_damaged = Die Aufgabenliste ist beschädigt ({ $detail }).
    .why = Nichts davon wird ausgeführt.
    .do = Den Befehl erneut ausführen, der sie schrieb.

task-list_no_task = Diese Zeile der Liste ist keine Aufgabe ({ $detail }).
    .why = Die Liste ist beschädigt; nichts davon wird ausgeführt.
    .do = Den Befehl erneut ausführen, der sie schrieb.

task-list_no_key = { $name } ist kein Schlüssel eines Produkts.
    .why = Die Liste ist beschädigt; nichts davon wird ausgeführt.
    .do = Den Befehl erneut ausführen, der sie schrieb.

task-list_count = Die Liste hat { $n } Aufgaben; geschrieben wurden { $needed }.
    .why = Die Liste ist beschädigt; nichts davon wird ausgeführt.
    .do = Den Befehl erneut ausführen, der sie schrieb.

task-list_checksum = Die Prüfsumme der Aufgabenliste ist falsch.
    .why = Die Liste ist beschädigt; nichts davon wird ausgeführt.
    .do = Den Befehl erneut ausführen, der sie schrieb.

task-failed = Eine Aufgabe endete mit einem internen Fehler: { $kind } ({ $detail })

task-needs_failed = Ein Produkt, das diese Aufgabe braucht, lässt sich nicht berechnen:

task-process_died = Der Prozess der Aufgabe endete ohne Ergebnis.
    .why = Vermutlich fehlt Arbeitsspeicher.
    .do = Weniger { OPTION("jobs") } verwenden.

task-failed_repeatedly = { $name }: { $n } Versuche scheiterten.
    .do = Siehe { $log }.
