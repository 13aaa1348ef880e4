"""Results of adjustments as folders: tables, result.json, written whole and read again."""
