costs-estimated = Schätzung für { $n } Aufnahmen mit { $megapixels } MP: CPU { $cpu }, Laufzeit { $wall }, Platte { $disk }.

costs-tightest = Keine Grenze wird überschritten; am knappsten ist { $what }: { $needed } von { $given }.

costs-assumed = Annahmen: { $points } Bildpunkte, { $overlap } Aufnahmen einer Stelle, { $iterations } Iterationen.

costs-dominant = Größter Anteil: { $stage }, { PERCENT($share) } % der CPU-Zeit (abhängig von { $by }).

costs-largest_matrix = Reduktion aufwärts: die größte Matrix eines Teils hat { $n } Unbekannte.

costs-not_included = Nicht enthalten: die Oberfläche und die weiteren Ausgleichungen, in denen orient grobe Fehler verwirft.

costs-measured = Gemessen auf { $processor }, { $date }.

costs-idle = { $workers } Worker: in { PERCENT($share) } % der Laufzeit haben einige keine Aufgabe.

costs-memory_remedy = Einen Rechner mit { $size }, weniger Punkte ({ OPTION("feature_count", "N") }) oder mit raybundle merge verbundene Teile verwenden.

costs-precision_remedy = { OPTION("quick", "True") } von orient lässt die Präzision weg: um ein Mehrfaches ungenauer.

costs-disk_remedy = Die Produkte auf eine andere Platte oder in einen Objektspeicher legen ({ OPTION("store", "URL") } von orient).
