// How much memory a process may take, and what happens when it asks for more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fiberfate {

/// Whether a sanitizer keeps shadow memory, which is larger than any limit.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool has_shadow_memory = true;
#elif defined(__has_feature)
inline constexpr bool has_shadow_memory = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool has_shadow_memory = false;
#endif

/// How much address space this process holds, bytes.
[[nodiscard]] std::uint64_t held_address_space();

/// How much memory this process may still take, bytes: the least of what the machine has free, with its swap,
/// and of what the limits of the process (ulimit -v and -d) and of its control groups leave.
[[nodiscard]] double free_memory_bytes();

/// Makes allocations beyond the memory of the machine and its control groups fail (std::bad_alloc). Without a
/// bound the system grants them, and ends the process without a word once it uses them.
void bound_memory();

/// Raises bad_alloc unless so many bytes could still be had, for libraries that crash or end the program
/// where their own allocations fail. They are mapped, not allocated: allocations behave afterwards as before.
void require_room(std::size_t bytes);

/// Tells an amount of memory, "about 40 MB".
[[nodiscard]] std::string memory_text(double bytes);

/// Raises InputError where more than the free memory is needed; `remedy` says what takes less.
void require_memory(double bytes, const std::string& remedy);

}  // namespace fiberfate
