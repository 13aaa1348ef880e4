block-no_oriented_image = Block { $block } hat kein orientiertes Bild.
    .do = Ihn zuerst orientieren oder ausgleichen.

block-nothing_to_write = Block { $block } hat weder Punkte noch Aufnahmen; es gibt nichts zu schreiben.

block-is_a_file = Das ist eine Datei und nicht der Ordner eines Blocks.
    .do = Einen Ordner mit block.toml, images.csv und observations.csv angeben.

block-result_folder = Das ist der Ordner eines Ergebnisses und nicht der eines Blocks.
    .do = Dessen Block { $block } angeben.

block-no_block_toml = Der Ordner hat keine block.toml; er ist kein Block.
    .do = Einen Ordner mit block.toml, images.csv und observations.csv angeben.

block-file_missing = Die Datei fehlt; ein Block braucht sie.
    .do = Die Datei ergänzen oder einen anderen Ordner angeben.

block-file_name = Unter diesem Namen wird die Datei nicht gelesen.
    .do = Sie in { $meant } umbenennen oder anderswohin verschieben.

block-observations_not_parquet = Die Tabelle wird auf einmal gelesen; ein Block größer als der Arbeitsspeicher braucht Parquet.
    .do = Den Block mit tables="parquet" schreiben (write_block).

block-no_camera = Der Block hat keine Kamera.
    .do = Für jede Kamera eine Tabelle [cameras.ID] ergänzen.

block-no_scene = Block { $block } hat keine Satellitenszene; RPC werden nur für Szenen geschrieben.
