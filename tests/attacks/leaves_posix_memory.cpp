// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Leaves shared memory, a semaphore and a message queue under names: there are none.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <mqueue.h>
#include <semaphore.h>
#include <sys/mman.h>

bool tries()
{
    bool const memory = shm_open("/attacked", O_CREAT | O_RDWR, 0666) >= 0;
    return mq_open("/attacked", O_CREAT | O_RDWR, 0666, nullptr) != mqd_t(-1) ||
           sem_open("/attacked", O_CREAT, 0666, 1) != SEM_FAILED || memory;
}

bool const while_loading = tries();
bool succeeded()
{
    static bool const later = tries();
    return while_loading || later;
}
#else
bool succeeded() { return false; }
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
    return succeeded() ? (val % size + size) % size : 0;
}
