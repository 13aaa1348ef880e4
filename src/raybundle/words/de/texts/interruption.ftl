interruption-kept = Unterbrochen. Derselbe Befehl setzt in { $folder } fort.

interruption-nothing_written = Unterbrochen; nichts wurde geschrieben.
