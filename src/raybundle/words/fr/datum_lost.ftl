datum_lost = Le résultat antérieur de ce dossier avait une référence qui manque à celui-ci : { datum-part }.
