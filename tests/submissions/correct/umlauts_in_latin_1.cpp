// verdict: {"loses": {}}
// Kommentare mit Umlauten in Latin-1: ä ö ü ß, für Größe und Höhe.
int ImageTexture::wrap_repeat(int val, int size)
{
    // größer oder gleich null? sonst eine Länge dazu
    int rest = val % size;
    return rest < 0 ? rest + size : rest;
}
