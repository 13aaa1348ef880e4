task_share-done = Erledigte Aufgaben: { $n }; auf andere Anteile warten: { $waiting }.

task_share-failed = Die Aufgabe { $name } ist gescheitert.

task_share-again = Denselben Befehl wiederholen, wenn die anderen Anteile fertig sind.
