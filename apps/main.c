/* The wirecut command. */
int main(void) { return 2; }
