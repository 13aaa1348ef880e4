archive-file_missing = L'archive n'a pas de fichier { $name }.

archive-file_too_large = { $name } dans l'archive a { $size_bytes } octets ; { $limit_bytes } au plus sont lus.

archive-not_unpacked = L'archive ne peut être décompressée ({ $detail }).
