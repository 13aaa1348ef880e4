in_parts = Les équations normales ont été réduites en { $parts } parties (Helmert-Wolf).

in_parts-least = Les équations normales ont été réduites en { $parts } parties et demandent encore environ { $least_gb } GB.

in_parts-cluster = Les équations normales ont été réduites en { $parts } parties par un cluster (Helmert-Wolf).
