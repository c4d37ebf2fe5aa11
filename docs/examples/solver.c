// SPDX-License-Identifier: BSL-1.0
// A frictionless collision response that takes and gives hexadecimal doubles in place of JSON. Build it with
// cc -O2 -o my-solver solver.c -lm
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  double immovable, mass, moments[3], orientation[4], position[3], velocity[3], angular_velocity[3];
} Body;

// The 45 numbers of a request, in their order. No member is padded, because all are doubles.
typedef struct {
  Body body[2];  // a and b
  double point[3], normal[3], restitution, friction, tangential_restitution;
} Collision;

static double dot(const double* u, const double* v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

static void cross(const double* u, const double* v, double* product) {
  for (int i = 0; i < 3; ++i) {
    product[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
  }
}

// Divides by the largest component first, so that no square overflows or underflows.
static void make_unit(double* v, int size) {
  double largest = 0;
  double square = 0;
  for (int i = 0; i < size; ++i) {
    largest = fmax(largest, fabs(v[i]));
  }
  for (int i = 0; i < size; ++i) {
    v[i] /= largest;
    square += v[i] * v[i];
  }
  for (int i = 0; i < size; ++i) {
    v[i] /= sqrt(square);
  }
}

// The columns are the body axes in world coordinates.
static void axes_of(const double* orientation, double axes[3][3]) {
  double q[4];
  memcpy(q, orientation, sizeof q);
  make_unit(q, 4);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double rotation[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                                 {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                                 {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  memcpy(axes, rotation, sizeof rotation);
}

static void to_body_axes(double axes[3][3], const double* v, double* turned) {
  for (int i = 0; i < 3; ++i) {
    turned[i] = axes[0][i] * v[0] + axes[1][i] * v[1] + axes[2][i] * v[2];
  }
}

// Writes the change of spin of a movable body by an impulse of size 1 along the normal. Returns the change of its
// contact point's velocity along the normal. It turns lever arm and normal into body axes first: in world axes,
// rounding would turn a thin rod about its long axis.
static double response(const Body* body, const double* arm, const double* normal, double* spin) {
  double axes[3][3], arm_there[3], normal_there[3], torque[3], divided[3];
  axes_of(body->orientation, axes);
  to_body_axes(axes, arm, arm_there);
  to_body_axes(axes, normal, normal_there);
  cross(arm_there, normal_there, torque);
  for (int i = 0; i < 3; ++i) {
    divided[i] = torque[i] / body->moments[i];
  }
  for (int i = 0; i < 3; ++i) {
    spin[i] = dot(axes[i], divided);
  }
  return 1 / body->mass + dot(torque, divided);
}

// Changes the velocities of both bodies to those after the impulse.
static void solve(Collision* c) {
  double spin[2][3], approach = 0, inertness = 0;
  make_unit(c->normal, 3);
  for (int k = 0; k < 2; ++k) {
    const Body* const body = &c->body[k];
    double arm[3], turning[3], at_contact[3];
    for (int i = 0; i < 3; ++i) {
      arm[i] = c->point[i] - body->position[i];
    }
    cross(body->angular_velocity, arm, turning);
    for (int i = 0; i < 3; ++i) {
      at_contact[i] = body->velocity[i] + turning[i];
    }
    approach += (k == 0 ? 1 : -1) * dot(c->normal, at_contact);
    inertness += body->immovable != 0 ? 0 : response(body, arm, c->normal, spin[k]);
  }
  if (!(approach < 0) || inertness == 0) {
    return;
  }
  const double impulse = -(1 + c->restitution) * approach / inertness;
  for (int k = 0; k < 2; ++k) {
    Body* const body = &c->body[k];
    const double signed_impulse = k == 0 ? impulse : -impulse;
    for (int i = 0; i < 3 && body->immovable == 0; ++i) {
      body->velocity[i] += signed_impulse / body->mass * c->normal[i];
      body->angular_velocity[i] += signed_impulse * spin[k][i];
    }
  }
}

static bool all_finite(const double* numbers, int count) {
  while (count > 0 && isfinite(numbers[count - 1])) {
    --count;
  }
  return count == 0;
}

static bool is_zero(const double* numbers, int count) {
  while (count > 0 && numbers[count - 1] == 0) {
    --count;
  }
  return count == 0;
}

// The defect of the input; null if there is none.
static const char* defect(const Collision* c) {
  if (!all_finite((const double*)c, sizeof *c / sizeof(double))) {
    return "every number must be finite";
  }
  for (int k = 0; k < 2; ++k) {
    const Body* const body = &c->body[k];
    const double* const m = body->moments;
    if (body->immovable == 0 && !(body->mass > 0 && m[0] > 0 && m[1] > 0 && m[2] > 0)) {
      return "mass and moments of inertia must be positive";
    }
    if (body->immovable == 0 && is_zero(body->orientation, 4)) {
      return "an orientation must not be zero";
    }
  }
  if (is_zero(c->normal, 3)) {
    return "the normal must not be zero";
  }
  return c->restitution >= 0 && c->restitution <= 1 ? NULL : "restitution must be in [0, 1]";
}

// Reads 45 numbers: a space and 16 hexadecimal digits each.
static void read_collision(const char* text, Collision* c) {
  for (double* number = (double*)c; number < (double*)(c + 1); ++number) {
    uint64_t bits = 0;
    ++text;  // the space
    for (int i = 0; i < 16; ++i, ++text) {
      bits = bits << 4 | (uint64_t)(*text <= '9' ? *text - '0' : *text - 'a' + 10);
    }
    memcpy(number, &bits, sizeof bits);
  }
}

static void write_vector(const double* v) {
  char text[3 * 17];
  for (int i = 0; i < 3; ++i) {
    uint64_t bits = 0;
    memcpy(&bits, &v[i], sizeof bits);
    text[17 * i] = ' ';
    for (int digit = 16; digit > 0; --digit, bits >>= 4) {
      text[17 * i + digit] = "0123456789abcdef"[bits & 15];
    }
  }
  fwrite(text, sizeof text, 1, stdout);
}

static void reply_to(const char* request) {
  const size_t id_size = strspn(request, "0123456789");
  Collision collision;
  if (strlen(request) < id_size + 45 * 17) {
    exit(2);
  }
  read_collision(request + id_size, &collision);
  fwrite(request, id_size, 1, stdout);
  const char* const why = defect(&collision);
  if (why != NULL) {
    printf(" error %s\n", why);
    return;
  }
  solve(&collision);
  for (int k = 0; k < 2; ++k) {
    write_vector(collision.body[k].velocity);
    write_vector(collision.body[k].angular_velocity);
  }
  putchar('\n');
}

int main(void) {
  char line[1024];
  while (fgets(line, sizeof line, stdin) != NULL && strstr(line, "\"stop\"") == NULL) {
    if (line[0] == '{') {
      puts(
          "{\"protocol\":1,\"name\":\"example-c\",\"version\":\"1\",\"precision\":\"binary64\","
          "\"model\":\"frictionless\",\"numbers\":\"hex\"}");
    } else {
      reply_to(line);
    }
    fflush(stdout);
  }
  return 0;
}
