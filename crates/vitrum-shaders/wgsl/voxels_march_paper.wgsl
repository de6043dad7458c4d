struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_9,
member_18: type_11,
member_19: type_5,
member_20: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_19 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: i32,
member_13: i32,
member_14: f32,
}
struct type_21 {
member: array<u32>,
}
struct type_24 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(4)
var<storage> global_2: type_16;
@group(0) @binding(5)
var<storage, read_write> global_3: type_16;
@group(0) @binding(6)
var<storage, read_write> global_4: type_24;
@group(0) @binding(1)
var<storage> global_5: type_21;
@group(0) @binding(2)
var<storage> global_6: type_21;
@group(0) @binding(3)
var<storage> global_7: type_16;
fn function_() {
var phi_640_: u32;
var phi_719_: type_19;
var phi_722_: i32;
var phi_1341_: type_19;
var phi_1054_: type_19;
var phi_1342_: type_19;
var phi_2146_: type_19;
var phi_2199_: type_19;
var phi_2213_: type_19;
var phi_2657_: type_19;
var phi_2658_: type_19;
var phi_2638_: type_19;
var phi_2659_: type_19;
var phi_2668_: type_19;
var phi_2669_: type_19;
var phi_2670_: type_19;
var phi_1674_: type_19;
var phi_2671_: type_19;
var phi_720_: type_19;
var phi_723_: i32;
var local: type_19;
var local_1: type_19;
var local_2: type_19;
var local_3: type_19;
var local_4: type_19;
var local_5: type_19;
var local_6: type_19;
var local_7: type_19;
var local_8: type_19;
var local_9: type_19;
var local_10: type_19;
var local_11: type_19;
var local_12: type_19;
var local_13: type_19;
var local_14: type_19;
var local_15: type_19;
var local_16: type_19;
var local_17: type_19;
var local_18: type_19;
var local_19: type_19;
var local_20: type_19;
var local_21: type_19;
var local_22: type_19;
var local_23: type_19;
var local_24: f32;
let _e80 = global;
let _e88 = arrayLength((&global_2.member));
let _e95 = global_1.member.member;
if (_e80.x < _e95.member) {
if (_e80.y < _e95.member_1) {
let _e102 = (_e95.member * _e95.member_1);
let _e104 = ((_e80.y * _e95.member) + _e80.x);
let _e105 = bitcast<i32>(_e104);
let _e107 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e109 = select(_e107, _e105, (_e105 < _e107));
let _e115 = global_3.member[bitcast<u32>(select(0i, _e109, (_e109 > 0i)))];
let _e116 = (_e102 + _e104);
let _e117 = bitcast<i32>(_e116);
let _e119 = select(_e107, _e117, (_e117 < _e107));
let _e125 = global_3.member[bitcast<u32>(select(0i, _e119, (_e119 > 0i)))];
let _e127 = ((2u * _e102) + _e104);
let _e128 = bitcast<i32>(_e127);
let _e130 = select(_e107, _e128, (_e128 < _e107));
let _e136 = global_3.member[bitcast<u32>(select(0i, _e130, (_e130 > 0i)))];
let _e138 = ((3u * _e102) + _e104);
let _e139 = bitcast<i32>(_e138);
let _e141 = select(_e107, _e139, (_e139 < _e107));
let _e147 = global_3.member[bitcast<u32>(select(0i, _e141, (_e141 > 0i)))];
let _e149 = ((4u * _e102) + _e104);
let _e150 = bitcast<i32>(_e149);
let _e152 = select(_e107, _e150, (_e150 < _e107));
let _e158 = global_3.member[bitcast<u32>(select(0i, _e152, (_e152 > 0i)))];
let _e160 = ((5u * _e102) + _e104);
let _e161 = bitcast<i32>(_e160);
let _e163 = select(_e107, _e161, (_e161 < _e107));
let _e169 = global_3.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e171 = ((6u * _e102) + _e104);
let _e172 = bitcast<i32>(_e171);
let _e174 = select(_e107, _e172, (_e172 < _e107));
let _e180 = global_3.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = ((7u * _e102) + _e104);
let _e183 = bitcast<i32>(_e182);
let _e185 = select(_e107, _e183, (_e183 < _e107));
let _e191 = global_3.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = ((8u * _e102) + _e104);
let _e194 = bitcast<i32>(_e193);
let _e196 = select(_e107, _e194, (_e194 < _e107));
let _e202 = global_3.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = ((9u * _e102) + _e104);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e107, _e205, (_e205 < _e107));
let _e213 = global_3.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e215 = ((10u * _e102) + _e104);
let _e216 = bitcast<i32>(_e215);
let _e218 = select(_e107, _e216, (_e216 < _e107));
let _e224 = global_3.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e226 = ((11u * _e102) + _e104);
let _e227 = bitcast<i32>(_e226);
let _e229 = select(_e107, _e227, (_e227 < _e107));
let _e235 = global_3.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e237 = ((12u * _e102) + _e104);
let _e238 = bitcast<i32>(_e237);
let _e240 = select(_e107, _e238, (_e238 < _e107));
let _e246 = global_3.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e248 = ((13u * _e102) + _e104);
let _e249 = bitcast<i32>(_e248);
let _e251 = select(_e107, _e249, (_e249 < _e107));
let _e257 = global_3.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e259 = ((14u * _e102) + _e104);
let _e260 = bitcast<i32>(_e259);
let _e262 = select(_e107, _e260, (_e260 < _e107));
let _e268 = global_3.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e270 = ((15u * _e102) + _e104);
let _e271 = bitcast<i32>(_e270);
let _e273 = select(_e107, _e271, (_e271 < _e107));
let _e279 = global_3.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e281 = ((16u * _e102) + _e104);
let _e282 = bitcast<i32>(_e281);
let _e284 = select(_e107, _e282, (_e282 < _e107));
let _e290 = global_3.member[bitcast<u32>(select(0i, _e284, (_e284 > 0i)))];
let _e292 = ((17u * _e102) + _e104);
let _e293 = bitcast<i32>(_e292);
let _e295 = select(_e107, _e293, (_e293 < _e107));
let _e301 = global_3.member[bitcast<u32>(select(0i, _e295, (_e295 > 0i)))];
let _e303 = ((18u * _e102) + _e104);
let _e304 = bitcast<i32>(_e303);
let _e306 = select(_e107, _e304, (_e304 < _e107));
let _e312 = global_3.member[bitcast<u32>(select(0i, _e306, (_e306 > 0i)))];
let _e314 = ((19u * _e102) + _e104);
let _e315 = bitcast<i32>(_e314);
let _e317 = select(_e107, _e315, (_e315 < _e107));
let _e323 = global_3.member[bitcast<u32>(select(0i, _e317, (_e317 > 0i)))];
let _e325 = ((20u * _e102) + _e104);
let _e326 = bitcast<i32>(_e325);
let _e328 = select(_e107, _e326, (_e326 < _e107));
let _e334 = global_3.member[bitcast<u32>(select(0i, _e328, (_e328 > 0i)))];
let _e336 = ((21u * _e102) + _e104);
let _e337 = bitcast<i32>(_e336);
let _e339 = select(_e107, _e337, (_e337 < _e107));
let _e345 = global_3.member[bitcast<u32>(select(0i, _e339, (_e339 > 0i)))];
let _e347 = ((22u * _e102) + _e104);
let _e348 = bitcast<i32>(_e347);
let _e350 = select(_e107, _e348, (_e348 < _e107));
let _e356 = global_3.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
let _e358 = ((23u * _e102) + _e104);
let _e359 = bitcast<i32>(_e358);
let _e361 = select(_e107, _e359, (_e359 < _e107));
let _e367 = global_3.member[bitcast<u32>(select(0i, _e361, (_e361 > 0i)))];
let _e369 = ((24u * _e102) + _e104);
let _e370 = bitcast<i32>(_e369);
let _e372 = select(_e107, _e370, (_e370 < _e107));
let _e378 = global_3.member[bitcast<u32>(select(0i, _e372, (_e372 > 0i)))];
if (_e290 == 0f) {
phi_640_ = 3u;
} else {
phi_640_ = select(0u, 1u, (_e290 == 4f));
}
let _e383 = phi_640_;
if (_e383 > 0u) {
if (arrayLength((&global_4.member)) >= 3u) {
let _e392 = atomicLoad((&global_4.member[0u]));
if (_e392 == 0u) {
atomicStore((&global_4.member[0u]), ((_e95.member + 7u) / 8u));
atomicStore((&global_4.member[1u]), ((_e95.member_1 + 7u) / 8u));
atomicStore((&global_4.member[2u]), 1u);
}
}
}
if (_e383 > 1u) {
let _e430 = global_1.member.member_2.member;
let _e431 = bitcast<i32>(_e430);
let _e435 = global_1.member.member_2.member_1;
let _e436 = bitcast<i32>(_e435);
let _e440 = global_1.member.member_2.member_2;
let _e441 = bitcast<i32>(_e440);
phi_719_ = type_19(vec3<f32>(_e115, _e125, _e136), vec3<f32>(_e147, _e158, _e169), vec3<f32>(_e180, _e191, _e202), vec3<f32>(_e213, _e224, _e235), vec3<f32>(_e246, _e257, _e268), _e279, _e290, select(0i, select(select(i32(_e301), i32(-2147483648), (_e301 < -2147483600f)), 2147483647i, (_e301 > 2147483500f)), (_e301 == _e301)), _e312, _e323, _e334, _e345, select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < -2147483600f)), 2147483647i, (_e356 > 2147483500f)), (_e356 == _e356)), select(0i, select(select(i32(_e367), i32(-2147483648), (_e367 < -2147483600f)), 2147483647i, (_e367 > 2147483500f)), (_e367 == _e367)), _e378);
phi_722_ = 0i;
loop {
let _e446 = phi_719_;
let _e448 = phi_722_;
local = _e446;
local_1 = _e446;
local_2 = _e446;
local_3 = _e446;
local_4 = _e446;
local_5 = _e446;
local_6 = _e446;
local_7 = _e446;
local_8 = _e446;
local_9 = _e446;
local_10 = _e446;
local_11 = _e446;
local_12 = _e446;
local_13 = _e446;
local_14 = _e446;
local_15 = _e446;
local_16 = _e446;
local_17 = _e446;
local_18 = _e446;
local_19 = _e446;
local_20 = _e446;
local_21 = _e446;
local_22 = _e446;
local_23 = _e446;
let _e452 = ((_e448 < 256i) && (_e446.member_6 == 0f));
local_24 = _e446.member_6;
if _e452 {
let _e458 = bitcast<f32>((bitcast<u32>(_e446.member_1.x) & 2147483647u));
let _e462 = bitcast<f32>((bitcast<u32>(_e446.member_1.y) & 2147483647u));
let _e464 = select(_e462, _e458, (_e458 > _e462));
let _e468 = bitcast<f32>((bitcast<u32>(_e446.member_1.z) & 2147483647u));
let _e470 = select(_e468, _e464, (_e464 > _e468));
let _e473 = (1f / select(0.5f, _e470, (_e470 > 0.5f)));
let _e475 = (_e446.member_14 <= _e473);
if _e475 {
let _e805 = type_19(vec3<f32>((_e446.member.x + (_e446.member_1.x * _e446.member_14)), (_e446.member.y + (_e446.member_1.y * _e446.member_14)), (_e446.member.z + (_e446.member_1.z * _e446.member_14))), _e446.member_1, _e446.member_2, _e446.member_3, _e446.member_4, _e446.member_5, _e446.member_6, _e446.member_7, _e446.member_8, _e446.member_9, _e446.member_10, _e446.member_11, _e446.member_12, _e446.member_13, _e446.member_14);
let _e822 = type_19(_e805.member, _e805.member_1, _e805.member_2, _e805.member_3, _e805.member_4, (_e446.member_5 + _e446.member_14), _e805.member_6, _e805.member_7, _e805.member_8, _e805.member_9, _e805.member_10, _e805.member_11, _e805.member_12, _e805.member_13, _e805.member_14);
let _e838 = type_19(_e822.member, _e822.member_1, _e822.member_2, _e822.member_3, _e822.member_4, _e822.member_5, _e822.member_6, _e822.member_7, _e822.member_8, _e822.member_9, _e822.member_10, _e822.member_11, _e822.member_12, _e822.member_13, (_e446.member_14 - _e446.member_14));
let _e858 = type_19(_e838.member, _e838.member_1, _e838.member_2, _e838.member_3, _e838.member_4, _e838.member_5, _e838.member_6, _e838.member_7, _e838.member_8, _e838.member_9, (_e446.member_10 + select(0f, _e446.member_14, (_e446.member_8 == 0f))), _e838.member_11, _e838.member_12, _e838.member_13, _e838.member_14);
if (_e446.member_7 != 16i) {
let _e876 = type_19(_e858.member, _e858.member_1, _e858.member_2, _e858.member_3, _e858.member_4, _e858.member_5, _e858.member_6, _e858.member_7, _e858.member_8, (_e446.member_9 + _e446.member_14), _e858.member_10, _e858.member_11, _e858.member_12, _e858.member_13, _e858.member_14);
let _e877 = (_e446.member_7 * 4i);
let _e878 = (_e877 + 1i);
let _e880 = (bitcast<i32>(_e88) - 1i);
let _e882 = select(_e880, _e878, (_e878 < _e880));
let _e888 = global_2.member[bitcast<u32>(select(0i, _e882, (_e882 > 0i)))];
let _e890 = -((_e888 * _e446.member_14));
let _e892 = select(-87f, _e890, (_e890 > -87f));
let _e894 = select(88f, _e892, (_e892 < 88f));
let _e896 = ((_e894 * 1.442695f) + 0.5f);
let _e898 = select(-127f, _e896, (_e896 > -127f));
let _e900 = select(128f, _e898, (_e898 < 128f));
let _e907 = select(0i, select(select(i32(_e900), i32(-2147483648), (_e900 < -2147483600f)), 2147483647i, (_e900 > 2147483500f)), (_e900 == _e900));
let _e911 = (_e907 - select(0i, 1i, (_e900 < f32(_e907))));
let _e912 = f32(_e911);
let _e916 = ((_e894 - (_e912 * 0.6933594f)) - (_e912 * -2.1219444e-4f));
let _e940 = (_e877 + 2i);
let _e942 = select(_e880, _e940, (_e940 < _e880));
let _e948 = global_2.member[bitcast<u32>(select(0i, _e942, (_e942 > 0i)))];
let _e950 = -((_e948 * _e446.member_14));
let _e952 = select(-87f, _e950, (_e950 > -87f));
let _e954 = select(88f, _e952, (_e952 < 88f));
let _e956 = ((_e954 * 1.442695f) + 0.5f);
let _e958 = select(-127f, _e956, (_e956 > -127f));
let _e960 = select(128f, _e958, (_e958 < 128f));
let _e967 = select(0i, select(select(i32(_e960), i32(-2147483648), (_e960 < -2147483600f)), 2147483647i, (_e960 > 2147483500f)), (_e960 == _e960));
let _e971 = (_e967 - select(0i, 1i, (_e960 < f32(_e967))));
let _e972 = f32(_e971);
let _e976 = ((_e954 - (_e972 * 0.6933594f)) - (_e972 * -2.1219444e-4f));
let _e1000 = (_e877 + 3i);
let _e1002 = select(_e880, _e1000, (_e1000 < _e880));
let _e1008 = global_2.member[bitcast<u32>(select(0i, _e1002, (_e1002 > 0i)))];
let _e1010 = -((_e1008 * _e446.member_14));
let _e1012 = select(-87f, _e1010, (_e1010 > -87f));
let _e1014 = select(88f, _e1012, (_e1012 < 88f));
let _e1016 = ((_e1014 * 1.442695f) + 0.5f);
let _e1018 = select(-127f, _e1016, (_e1016 > -127f));
let _e1020 = select(128f, _e1018, (_e1018 < 128f));
let _e1027 = select(0i, select(select(i32(_e1020), i32(-2147483648), (_e1020 < -2147483600f)), 2147483647i, (_e1020 > 2147483500f)), (_e1020 == _e1020));
let _e1031 = (_e1027 - select(0i, 1i, (_e1020 < f32(_e1027))));
let _e1032 = f32(_e1031);
let _e1036 = ((_e1014 - (_e1032 * 0.6933594f)) - (_e1032 * -2.1219444e-4f));
phi_1054_ = type_19(_e876.member, _e876.member_1, vec3<f32>((_e446.member_2.x * ((1f + (_e916 * (1f + (_e916 * (0.5f + (_e916 * (0.16666667f + (_e916 * (0.041666668f + (_e916 * (0.008333334f + (_e916 * (0.001388889f + (_e916 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e911 + 127i)) << bitcast<u32>(23i))))), (_e446.member_2.y * ((1f + (_e976 * (1f + (_e976 * (0.5f + (_e976 * (0.16666667f + (_e976 * (0.041666668f + (_e976 * (0.008333334f + (_e976 * (0.001388889f + (_e976 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e971 + 127i)) << bitcast<u32>(23i))))), (_e446.member_2.z * ((1f + (_e1036 * (1f + (_e1036 * (0.5f + (_e1036 * (0.16666667f + (_e1036 * (0.041666668f + (_e1036 * (0.008333334f + (_e1036 * (0.001388889f + (_e1036 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1031 + 127i)) << bitcast<u32>(23i)))))), _e876.member_3, _e876.member_4, _e876.member_5, _e876.member_6, _e876.member_7, _e876.member_8, _e876.member_9, _e876.member_10, _e876.member_11, _e876.member_12, _e876.member_13, _e876.member_14);
} else {
phi_1054_ = _e858;
}
let _e1077 = phi_1054_;
phi_1342_ = type_19(_e1077.member, _e1077.member_1, _e1077.member_2, _e1077.member_3, _e1077.member_4, _e1077.member_5, 3f, _e1077.member_7, _e1077.member_8, _e1077.member_9, _e1077.member_10, _e1077.member_11, _e1077.member_12, _e1077.member_13, _e1077.member_14);
} else {
let _e504 = type_19(vec3<f32>((_e446.member.x + (_e446.member_1.x * _e473)), (_e446.member.y + (_e446.member_1.y * _e473)), (_e446.member.z + (_e446.member_1.z * _e473))), _e446.member_1, _e446.member_2, _e446.member_3, _e446.member_4, _e446.member_5, _e446.member_6, _e446.member_7, _e446.member_8, _e446.member_9, _e446.member_10, _e446.member_11, _e446.member_12, _e446.member_13, _e446.member_14);
let _e521 = type_19(_e504.member, _e504.member_1, _e504.member_2, _e504.member_3, _e504.member_4, (_e446.member_5 + _e473), _e504.member_6, _e504.member_7, _e504.member_8, _e504.member_9, _e504.member_10, _e504.member_11, _e504.member_12, _e504.member_13, _e504.member_14);
let _e537 = type_19(_e521.member, _e521.member_1, _e521.member_2, _e521.member_3, _e521.member_4, _e521.member_5, _e521.member_6, _e521.member_7, _e521.member_8, _e521.member_9, _e521.member_10, _e521.member_11, _e521.member_12, _e521.member_13, (_e446.member_14 - _e473));
let _e557 = type_19(_e537.member, _e537.member_1, _e537.member_2, _e537.member_3, _e537.member_4, _e537.member_5, _e537.member_6, _e537.member_7, _e537.member_8, _e537.member_9, (_e446.member_10 + select(0f, _e473, (_e446.member_8 == 0f))), _e537.member_11, _e537.member_12, _e537.member_13, _e537.member_14);
if (_e446.member_7 != 16i) {
let _e575 = type_19(_e557.member, _e557.member_1, _e557.member_2, _e557.member_3, _e557.member_4, _e557.member_5, _e557.member_6, _e557.member_7, _e557.member_8, (_e446.member_9 + _e473), _e557.member_10, _e557.member_11, _e557.member_12, _e557.member_13, _e557.member_14);
let _e576 = (_e446.member_7 * 4i);
let _e577 = (_e576 + 1i);
let _e579 = (bitcast<i32>(_e88) - 1i);
let _e581 = select(_e579, _e577, (_e577 < _e579));
let _e587 = global_2.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e589 = -((_e587 * _e473));
let _e591 = select(-87f, _e589, (_e589 > -87f));
let _e593 = select(88f, _e591, (_e591 < 88f));
let _e595 = ((_e593 * 1.442695f) + 0.5f);
let _e597 = select(-127f, _e595, (_e595 > -127f));
let _e599 = select(128f, _e597, (_e597 < 128f));
let _e606 = select(0i, select(select(i32(_e599), i32(-2147483648), (_e599 < -2147483600f)), 2147483647i, (_e599 > 2147483500f)), (_e599 == _e599));
let _e610 = (_e606 - select(0i, 1i, (_e599 < f32(_e606))));
let _e611 = f32(_e610);
let _e615 = ((_e593 - (_e611 * 0.6933594f)) - (_e611 * -2.1219444e-4f));
let _e639 = (_e576 + 2i);
let _e641 = select(_e579, _e639, (_e639 < _e579));
let _e647 = global_2.member[bitcast<u32>(select(0i, _e641, (_e641 > 0i)))];
let _e649 = -((_e647 * _e473));
let _e651 = select(-87f, _e649, (_e649 > -87f));
let _e653 = select(88f, _e651, (_e651 < 88f));
let _e655 = ((_e653 * 1.442695f) + 0.5f);
let _e657 = select(-127f, _e655, (_e655 > -127f));
let _e659 = select(128f, _e657, (_e657 < 128f));
let _e666 = select(0i, select(select(i32(_e659), i32(-2147483648), (_e659 < -2147483600f)), 2147483647i, (_e659 > 2147483500f)), (_e659 == _e659));
let _e670 = (_e666 - select(0i, 1i, (_e659 < f32(_e666))));
let _e671 = f32(_e670);
let _e675 = ((_e653 - (_e671 * 0.6933594f)) - (_e671 * -2.1219444e-4f));
let _e699 = (_e576 + 3i);
let _e701 = select(_e579, _e699, (_e699 < _e579));
let _e707 = global_2.member[bitcast<u32>(select(0i, _e701, (_e701 > 0i)))];
let _e709 = -((_e707 * _e473));
let _e711 = select(-87f, _e709, (_e709 > -87f));
let _e713 = select(88f, _e711, (_e711 < 88f));
let _e715 = ((_e713 * 1.442695f) + 0.5f);
let _e717 = select(-127f, _e715, (_e715 > -127f));
let _e719 = select(128f, _e717, (_e717 < 128f));
let _e726 = select(0i, select(select(i32(_e719), i32(-2147483648), (_e719 < -2147483600f)), 2147483647i, (_e719 > 2147483500f)), (_e719 == _e719));
let _e730 = (_e726 - select(0i, 1i, (_e719 < f32(_e726))));
let _e731 = f32(_e730);
let _e735 = ((_e713 - (_e731 * 0.6933594f)) - (_e731 * -2.1219444e-4f));
phi_1341_ = type_19(_e575.member, _e575.member_1, vec3<f32>((_e446.member_2.x * ((1f + (_e615 * (1f + (_e615 * (0.5f + (_e615 * (0.16666667f + (_e615 * (0.041666668f + (_e615 * (0.008333334f + (_e615 * (0.001388889f + (_e615 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e610 + 127i)) << bitcast<u32>(23i))))), (_e446.member_2.y * ((1f + (_e675 * (1f + (_e675 * (0.5f + (_e675 * (0.16666667f + (_e675 * (0.041666668f + (_e675 * (0.008333334f + (_e675 * (0.001388889f + (_e675 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e670 + 127i)) << bitcast<u32>(23i))))), (_e446.member_2.z * ((1f + (_e735 * (1f + (_e735 * (0.5f + (_e735 * (0.16666667f + (_e735 * (0.041666668f + (_e735 * (0.008333334f + (_e735 * (0.001388889f + (_e735 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e730 + 127i)) << bitcast<u32>(23i)))))), _e575.member_3, _e575.member_4, _e575.member_5, _e575.member_6, _e575.member_7, _e575.member_8, _e575.member_9, _e575.member_10, _e575.member_11, _e575.member_12, _e575.member_13, _e575.member_14);
} else {
phi_1341_ = _e557;
}
let _e776 = phi_1341_;
phi_1342_ = _e776;
}
let _e1094 = phi_1342_;
if (!(_e475) && ((((((_e1094.member.x < 0f) || (_e1094.member.y < 0f)) || (_e1094.member.z < 0f)) || (_e1094.member.x >= f32(_e431))) || (_e1094.member.y >= f32(_e436))) || (_e1094.member.z >= f32(_e441)))) {
if (_e1094.member_13 == -1i) {
phi_1674_ = type_19(_e1094.member, _e1094.member_1, _e1094.member_2, _e1094.member_3, _e1094.member_4, _e1094.member_5, 1f, _e1094.member_7, _e1094.member_8, _e1094.member_9, _e1094.member_10, _e1094.member_11, _e1094.member_12, _e1094.member_13, _e1094.member_14);
} else {
let _e1917 = type_19(vec3<f32>((_e1094.member.x + (_e1094.member_1.x * _e1094.member_14)), (_e1094.member.y + (_e1094.member_1.y * _e1094.member_14)), (_e1094.member.z + (_e1094.member_1.z * _e1094.member_14))), _e1094.member_1, _e1094.member_2, _e1094.member_3, _e1094.member_4, _e1094.member_5, _e1094.member_6, _e1094.member_7, _e1094.member_8, _e1094.member_9, _e1094.member_10, _e1094.member_11, _e1094.member_12, _e1094.member_13, _e1094.member_14);
let _e1934 = type_19(_e1917.member, _e1917.member_1, _e1917.member_2, _e1917.member_3, _e1917.member_4, (_e1094.member_5 + _e1094.member_14), _e1917.member_6, _e1917.member_7, _e1917.member_8, _e1917.member_9, _e1917.member_10, _e1917.member_11, _e1917.member_12, _e1917.member_13, _e1917.member_14);
let _e1950 = type_19(_e1934.member, _e1934.member_1, _e1934.member_2, _e1934.member_3, _e1934.member_4, _e1934.member_5, _e1934.member_6, _e1934.member_7, _e1934.member_8, _e1934.member_9, _e1934.member_10, _e1934.member_11, _e1934.member_12, _e1934.member_13, (_e1094.member_14 - _e1094.member_14));
let _e1970 = type_19(_e1950.member, _e1950.member_1, _e1950.member_2, _e1950.member_3, _e1950.member_4, _e1950.member_5, _e1950.member_6, _e1950.member_7, _e1950.member_8, _e1950.member_9, (_e1094.member_10 + select(0f, _e1094.member_14, (_e1094.member_8 == 0f))), _e1950.member_11, _e1950.member_12, _e1950.member_13, _e1950.member_14);
phi_1674_ = type_19(_e1970.member, _e1970.member_1, _e1970.member_2, _e1970.member_3, _e1970.member_4, _e1970.member_5, 3f, _e1970.member_7, _e1970.member_8, _e1970.member_9, _e1970.member_10, _e1970.member_11, _e1970.member_12, _e1970.member_13, _e1970.member_14);
}
let _e2002 = phi_1674_;
phi_2671_ = _e2002;
} else {
if _e475 {
phi_2670_ = _e1094;
} else {
let _e1116 = f32((_e431 - 1i));
let _e1118 = select(0f, _e1094.member.x, (_e1094.member.x > 0f));
let _e1120 = select(_e1116, _e1118, (_e1118 < _e1116));
let _e1127 = select(0i, select(select(i32(_e1120), i32(-2147483648), (_e1120 < -2147483600f)), 2147483647i, (_e1120 > 2147483500f)), (_e1120 == _e1120));
let _e1131 = (_e1127 - select(0i, 1i, (_e1120 < f32(_e1127))));
let _e1133 = f32((_e436 - 1i));
let _e1135 = select(0f, _e1094.member.y, (_e1094.member.y > 0f));
let _e1137 = select(_e1133, _e1135, (_e1135 < _e1133));
let _e1144 = select(0i, select(select(i32(_e1137), i32(-2147483648), (_e1137 < -2147483600f)), 2147483647i, (_e1137 > 2147483500f)), (_e1137 == _e1137));
let _e1150 = f32((_e441 - 1i));
let _e1152 = select(0f, _e1094.member.z, (_e1094.member.z > 0f));
let _e1154 = select(_e1150, _e1152, (_e1152 < _e1150));
let _e1161 = select(0i, select(select(i32(_e1154), i32(-2147483648), (_e1154 < -2147483600f)), 2147483647i, (_e1154 > 2147483500f)), (_e1154 == _e1154));
let _e1171 = (((((_e1161 - select(0i, 1i, (_e1154 < f32(_e1161)))) * _e436) + (_e1144 - select(0i, 1i, (_e1137 < f32(_e1144))))) * ((_e431 + 31i) >> bitcast<u32>(5i))) + (_e1131 >> bitcast<u32>(5i)));
let _e1173 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1175 = select(_e1173, _e1171, (_e1171 < _e1173));
let _e1181 = global_5.member[bitcast<u32>(select(0i, _e1175, (_e1175 > 0i)))];
let _e1184 = (bitcast<u32>((_e1131 & 31i)) & 31u);
if (((_e1181 >> bitcast<u32>(_e1184)) & 1u) == 1u) {
let _e1190 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e1192 = select(_e1190, _e1171, (_e1171 < _e1190));
let _e1198 = global_6.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1206 = (bitcast<i32>((_e1198 + countOneBits((_e1181 & ((1u << bitcast<u32>(_e1184)) - 1u))))) * 4i);
let _e1208 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1210 = select(_e1208, _e1206, (_e1206 < _e1208));
let _e1216 = global_7.member[bitcast<u32>(select(0i, _e1210, (_e1210 > 0i)))];
let _e1217 = (_e1206 + 1i);
let _e1219 = select(_e1208, _e1217, (_e1217 < _e1208));
let _e1225 = global_7.member[bitcast<u32>(select(0i, _e1219, (_e1219 > 0i)))];
let _e1226 = (_e1206 + 2i);
let _e1228 = select(_e1208, _e1226, (_e1226 < _e1208));
let _e1234 = global_7.member[bitcast<u32>(select(0i, _e1228, (_e1228 > 0i)))];
let _e1235 = vec3<f32>(_e1216, _e1225, _e1234);
let _e1236 = (_e1206 + 3i);
let _e1238 = select(_e1208, _e1236, (_e1236 < _e1208));
let _e1244 = global_7.member[bitcast<u32>(select(0i, _e1238, (_e1238 > 0i)))];
let _e1246 = select(0f, _e1244, (_e1244 > 0f));
let _e1248 = select(16f, _e1246, (_e1246 < 16f));
let _e1255 = select(0i, select(select(i32(_e1248), i32(-2147483648), (_e1248 < -2147483600f)), 2147483647i, (_e1248 > 2147483500f)), (_e1248 == _e1248));
let _e1264 = (((_e446.member_1.x * _e1216) + (_e446.member_1.y * _e1225)) + (_e446.member_1.z * _e1234));
let _e1266 = select(16i, (_e1255 - select(0i, 1i, (_e1248 < f32(_e1255)))), (_e1264 < 0f));
let _e1280 = global_1.member.member_12;
if ((!(((_e1094.member_8 > 0f) && ((((_e1216 * _e1094.member_4.x) + (_e1225 * _e1094.member_4.y)) + (_e1234 * _e1094.member_4.z)) > _e1280))) && (_e1264 != 0f)) && (_e1266 != _e1094.member_7)) {
let _e1290 = (_e1094.member_7 * 4i);
let _e1292 = (bitcast<i32>(_e88) - 1i);
let _e1294 = select(_e1292, _e1290, (_e1290 < _e1292));
let _e1300 = global_2.member[bitcast<u32>(select(0i, _e1294, (_e1294 > 0i)))];
let _e1302 = select(_e1300, 1f, (_e1094.member_7 == 16i));
let _e1303 = (_e1266 * 4i);
let _e1305 = select(_e1292, _e1303, (_e1303 < _e1292));
let _e1311 = global_2.member[bitcast<u32>(select(0i, _e1305, (_e1305 > 0i)))];
let _e1313 = select(_e1311, 1f, (_e1266 == 16i));
let _e1323 = select(1f, -1f, ((((_e1094.member_1.x * _e1216) + (_e1094.member_1.y * _e1225)) + (_e1094.member_1.z * _e1234)) > 0f));
let _e1324 = (_e1216 * _e1323);
let _e1325 = (_e1225 * _e1323);
let _e1326 = (_e1234 * _e1323);
let _e1332 = -((((_e1094.member_1.x * _e1324) + (_e1094.member_1.y * _e1325)) + (_e1094.member_1.z * _e1326)));
let _e1334 = select(0f, _e1332, (_e1332 > 0f));
let _e1335 = (_e1302 / _e1313);
let _e1337 = (_e1334 * _e1334);
let _e1340 = (1f - ((_e1335 * _e1335) * (1f - _e1337)));
let _e1341 = (_e1340 <= 0f);
let _e1349 = ((_e1335 * _e1334) - sqrt(select(0f, _e1340, (_e1340 > 0f))));
let _e1356 = (2f * _e1334);
let _e1363 = select(((_e1094.member_1.x * _e1335) + (_e1324 * _e1349)), (_e1094.member_1.x + (_e1324 * _e1356)), _e1341);
let _e1364 = select(((_e1094.member_1.y * _e1335) + (_e1325 * _e1349)), (_e1094.member_1.y + (_e1325 * _e1356)), _e1341);
let _e1365 = select(((_e1094.member_1.z * _e1335) + (_e1326 * _e1349)), (_e1094.member_1.z + (_e1326 * _e1356)), _e1341);
let _e1370 = (((_e1363 * _e1363) + (_e1364 * _e1364)) + (_e1365 * _e1365));
let _e1373 = sqrt(select(0f, _e1370, (_e1370 > 0f)));
let _e1376 = (1f / select(1e-20f, _e1373, (_e1373 > 1e-20f)));
let _e1381 = (_e1313 / _e1302);
let _e1384 = (((_e1381 * _e1381) - 1f) + _e1337);
let _e1387 = sqrt(select(0f, _e1384, (_e1384 > 0f)));
let _e1388 = (_e1387 - _e1334);
let _e1389 = (_e1387 + _e1334);
let _e1392 = (_e1388 / select(1e-6f, _e1389, (_e1389 > 1e-6f)));
let _e1396 = ((_e1334 * _e1388) + 1f);
let _e1399 = (((_e1334 * _e1389) - 1f) / select(1e-6f, _e1396, (_e1396 > 1e-6f)));
let _e1412 = global_1.member.member_1;
let _e1415 = select(0f, select(select((((0.5f * _e1392) * _e1392) * (1f + (_e1399 * _e1399))), 1f, (_e1384 <= 0f)), 0f, (_e1302 == _e1313)), ((_e1412 & 1u) != 0u));
if (_e1094.member_8 == 0f) {
let _e1430 = type_19(_e1094.member, _e1094.member_1, _e1094.member_2, _e1235, _e1094.member_4, _e1094.member_5, _e1094.member_6, _e1094.member_7, _e1094.member_8, _e1094.member_9, _e1094.member_10, _e1094.member_11, _e1094.member_12, _e1094.member_13, _e1094.member_14);
phi_2146_ = type_19(_e1430.member, _e1430.member_1, _e1430.member_2, _e1430.member_3, _e1430.member_4, _e1430.member_5, _e1430.member_6, _e1430.member_7, _e1430.member_8, _e1430.member_9, _e1430.member_10, _e1415, _e1430.member_12, _e1430.member_13, _e1430.member_14);
} else {
phi_2146_ = _e1094;
}
let _e1447 = phi_2146_;
let _e1449 = (_e1447.member_8 + 1f);
let _e1464 = type_19(_e1447.member, _e1447.member_1, _e1447.member_2, _e1447.member_3, _e1447.member_4, _e1447.member_5, _e1447.member_6, _e1447.member_7, _e1449, _e1447.member_9, _e1447.member_10, _e1447.member_11, _e1447.member_12, _e1447.member_13, _e1447.member_14);
let _e1467 = ((_e95.member_2 == 0u) && (_e1449 >= 2f));
if (_e1341 && _e1467) {
let _e1492 = (((_e1447.member_1.x * _e1216) + (_e1447.member_1.y * _e1225)) + (_e1447.member_1.z * _e1234));
let _e1496 = (_e1447.member_1.x - (_e1216 * _e1492));
let _e1497 = (_e1447.member_1.y - (_e1225 * _e1492));
let _e1498 = (_e1447.member_1.z - (_e1234 * _e1492));
let _e1503 = (((_e1496 * _e1496) + (_e1497 * _e1497)) + (_e1498 * _e1498));
let _e1506 = sqrt(select(0f, _e1503, (_e1503 > 0f)));
let _e1509 = (1f / select(1e-20f, _e1506, (_e1506 > 1e-20f)));
phi_2199_ = type_19(_e1464.member, vec3<f32>((_e1496 * _e1509), (_e1497 * _e1509), (_e1498 * _e1509)), _e1464.member_2, _e1464.member_3, _e1464.member_4, _e1464.member_5, _e1464.member_6, _e1464.member_7, _e1464.member_8, _e1464.member_9, _e1464.member_10, _e1464.member_11, _e1464.member_12, _e1464.member_13, _e1464.member_14);
} else {
phi_2199_ = type_19(_e1464.member, vec3<f32>((_e1363 * _e1376), (_e1364 * _e1376), (_e1365 * _e1376)), _e1464.member_2, _e1464.member_3, _e1464.member_4, _e1464.member_5, _e1464.member_6, _e1464.member_7, _e1464.member_8, _e1464.member_9, _e1464.member_10, _e1464.member_11, _e1464.member_12, _e1464.member_13, _e1464.member_14);
}
let _e1530 = phi_2199_;
if _e1341 {
phi_2213_ = _e1530;
} else {
let _e1531 = (1f - _e1415);
phi_2213_ = type_19(_e1530.member, _e1530.member_1, vec3<f32>((_e1530.member_2.x * _e1531), (_e1530.member_2.y * _e1531), (_e1530.member_2.z * _e1531)), _e1530.member_3, _e1530.member_4, _e1530.member_5, _e1530.member_6, _e1530.member_7, _e1530.member_8, _e1530.member_9, _e1530.member_10, _e1530.member_11, _e1530.member_12, _e1530.member_13, _e1530.member_14);
}
let _e1558 = phi_2213_;
let _e1565 = global_1.member.member_17.member.member;
let _e1579 = ((((_e1565.member.member * _e1558.member.x) + (_e1565.member.member_1 * _e1558.member.y)) + (_e1565.member.member_2 * _e1558.member.z)) + _e1565.member_1);
let _e1588 = -((((_e1565.member.member * _e1558.member_1.x) + (_e1565.member.member_1 * _e1558.member_1.y)) + (_e1565.member.member_2 * _e1558.member_1.z)));
let _e1590 = (_e1588 > 1e-9f);
let _e1594 = ((_e1579 / select(1e-9f, _e1588, _e1590)) - 0.015625f);
let _e1597 = select(1e30f, select(0f, _e1594, (_e1594 > 0f)), ((_e1579 > 0f) && _e1590));
let _e1602 = global_1.member.member_17.member_1.member;
let _e1613 = ((((_e1602.member.member * _e1558.member.x) + (_e1602.member.member_1 * _e1558.member.y)) + (_e1602.member.member_2 * _e1558.member.z)) + _e1602.member_1);
let _e1619 = -((((_e1602.member.member * _e1558.member_1.x) + (_e1602.member.member_1 * _e1558.member_1.y)) + (_e1602.member.member_2 * _e1558.member_1.z)));
let _e1621 = (_e1619 > 1e-9f);
let _e1625 = ((_e1613 / select(1e-9f, _e1619, _e1621)) - 0.015625f);
let _e1628 = select(1e30f, select(0f, _e1625, (_e1625 > 0f)), ((_e1613 > 0f) && _e1621));
let _e1632 = (_e1628 < _e1597);
let _e1634 = select(select(-2i, -3i, _e1632), -1i, ((_e1597 >= 1e30f) && (_e1628 >= 1e30f)));
let _e1635 = select(_e1597, _e1628, _e1632);
let _e1650 = type_19(_e1558.member, _e1558.member_1, _e1558.member_2, _e1558.member_3, _e1558.member_4, _e1558.member_5, _e1558.member_6, _e1558.member_7, _e1558.member_8, _e1558.member_9, _e1558.member_10, _e1558.member_11, 0i, _e1558.member_13, _e1558.member_14);
let _e1665 = type_19(_e1650.member, _e1650.member_1, _e1650.member_2, _e1650.member_3, _e1650.member_4, _e1650.member_5, _e1650.member_6, _e1650.member_7, _e1650.member_8, _e1650.member_9, _e1650.member_10, _e1650.member_11, _e1650.member_12, _e1634, _e1650.member_14);
let _e1680 = type_19(_e1665.member, _e1665.member_1, _e1665.member_2, _e1665.member_3, _e1665.member_4, _e1665.member_5, _e1665.member_6, _e1665.member_7, _e1665.member_8, _e1665.member_9, _e1665.member_10, _e1665.member_11, _e1665.member_12, _e1665.member_13, _e1635);
let _e1683 = ((_e1412 & 2u) != 0u);
if (_e1467 && !(_e1683)) {
if (_e1634 == -1i) {
phi_2638_ = type_19(_e1680.member, _e1680.member_1, _e1680.member_2, _e1680.member_3, _e1680.member_4, _e1680.member_5, 1f, _e1680.member_7, _e1680.member_8, _e1680.member_9, _e1680.member_10, _e1680.member_11, _e1680.member_12, _e1680.member_13, _e1680.member_14);
} else {
let _e1759 = type_19(vec3<f32>((_e1558.member.x + (_e1558.member_1.x * _e1635)), (_e1558.member.y + (_e1558.member_1.y * _e1635)), (_e1558.member.z + (_e1558.member_1.z * _e1635))), _e1680.member_1, _e1680.member_2, _e1680.member_3, _e1680.member_4, _e1680.member_5, _e1680.member_6, _e1680.member_7, _e1680.member_8, _e1680.member_9, _e1680.member_10, _e1680.member_11, _e1680.member_12, _e1680.member_13, _e1680.member_14);
let _e1775 = type_19(_e1759.member, _e1759.member_1, _e1759.member_2, _e1759.member_3, _e1759.member_4, _e1759.member_5, _e1759.member_6, _e1759.member_7, _e1759.member_8, _e1759.member_9, _e1759.member_10, _e1759.member_11, _e1759.member_12, _e1759.member_13, (_e1635 - _e1635));
let _e1795 = type_19(_e1775.member, _e1775.member_1, _e1775.member_2, _e1775.member_3, _e1775.member_4, _e1775.member_5, _e1775.member_6, _e1775.member_7, _e1775.member_8, _e1775.member_9, (_e1558.member_10 + select(0f, _e1635, (_e1558.member_8 == 0f))), _e1775.member_11, _e1775.member_12, _e1775.member_13, _e1775.member_14);
phi_2638_ = type_19(_e1795.member, _e1795.member_1, _e1795.member_2, _e1795.member_3, _e1795.member_4, _e1795.member_5, 3f, _e1795.member_7, _e1795.member_8, _e1795.member_9, _e1795.member_10, _e1795.member_11, _e1795.member_12, _e1795.member_13, _e1795.member_14);
}
let _e1827 = phi_2638_;
phi_2659_ = _e1827;
} else {
let _e1690 = global_1.member.member_5;
if ((!(_e1467) && (_e1558.member_8 >= f32(bitcast<i32>(_e1690)))) && (select(_e1266, _e1094.member_7, _e1341) != 16i)) {
phi_2658_ = type_19(_e1680.member, _e1680.member_1, _e1680.member_2, _e1680.member_3, _e1680.member_4, _e1680.member_5, 2f, _e1680.member_7, _e1680.member_8, _e1680.member_9, _e1680.member_10, _e1680.member_11, _e1680.member_12, _e1680.member_13, _e1680.member_14);
} else {
if _e1683 {
phi_2657_ = type_19(_e1680.member, _e1680.member_1, _e1680.member_2, _e1680.member_3, _e1680.member_4, _e1680.member_5, 4f, _e1680.member_7, _e1680.member_8, _e1680.member_9, _e1680.member_10, _e1680.member_11, _e1680.member_12, _e1680.member_13, _e1680.member_14);
} else {
phi_2657_ = _e1680;
}
let _e1713 = phi_2657_;
phi_2658_ = _e1713;
}
let _e1730 = phi_2658_;
phi_2659_ = _e1730;
}
let _e1829 = phi_2659_;
let _e1846 = type_19(_e1829.member, _e1829.member_1, _e1829.member_2, _e1829.member_3, _e1829.member_4, _e1829.member_5, _e1829.member_6, select(_e1094.member_7, _e1266, !(_e1341)), _e1829.member_8, _e1829.member_9, _e1829.member_10, _e1829.member_11, _e1829.member_12, _e1829.member_13, _e1829.member_14);
let _e1861 = type_19(_e1846.member, _e1846.member_1, _e1846.member_2, _e1846.member_3, _e1235, _e1846.member_5, _e1846.member_6, _e1846.member_7, _e1846.member_8, _e1846.member_9, _e1846.member_10, _e1846.member_11, _e1846.member_12, _e1846.member_13, _e1846.member_14);
phi_2668_ = type_19(_e1861.member, _e1861.member_1, _e1861.member_2, _e1861.member_3, _e1861.member_4, 0f, _e1861.member_6, _e1861.member_7, _e1861.member_8, _e1861.member_9, _e1861.member_10, _e1861.member_11, _e1861.member_12, _e1861.member_13, _e1861.member_14);
} else {
phi_2668_ = _e1094;
}
let _e1878 = phi_2668_;
phi_2669_ = _e1878;
} else {
phi_2669_ = _e1094;
}
let _e1880 = phi_2669_;
phi_2670_ = _e1880;
}
let _e1882 = phi_2670_;
phi_2671_ = _e1882;
}
let _e2004 = phi_2671_;
phi_720_ = _e2004;
phi_723_ = (_e448 + 1i);
} else {
phi_720_ = type_19();
phi_723_ = i32();
}
let _e2006 = phi_720_;
let _e2008 = phi_723_;
continue;
continuing {
phi_719_ = _e2006;
phi_722_ = _e2008;
break if !(_e452);
}
}
let _e2011 = local;
let _e2015 = local_1;
let _e2019 = local_2;
let _e2023 = local_3;
let _e2027 = local_4;
let _e2031 = local_5;
let _e2035 = local_6;
let _e2039 = local_7;
let _e2043 = local_8;
let _e2047 = local_9;
let _e2051 = local_10;
let _e2055 = local_11;
let _e2059 = local_12;
let _e2063 = local_13;
let _e2067 = local_14;
let _e2071 = local_15;
let _e2074 = local_16;
let _e2078 = local_17;
let _e2081 = local_18;
let _e2084 = local_19;
let _e2087 = local_20;
let _e2090 = local_21;
let _e2094 = local_22;
let _e2098 = local_23;
global_3.member[_e104] = _e2011.member.x;
global_3.member[_e116] = _e2015.member.y;
global_3.member[_e127] = _e2019.member.z;
global_3.member[_e138] = _e2023.member_1.x;
global_3.member[_e149] = _e2027.member_1.y;
global_3.member[_e160] = _e2031.member_1.z;
global_3.member[_e171] = _e2035.member_2.x;
global_3.member[_e182] = _e2039.member_2.y;
global_3.member[_e193] = _e2043.member_2.z;
global_3.member[_e204] = _e2047.member_3.x;
global_3.member[_e215] = _e2051.member_3.y;
global_3.member[_e226] = _e2055.member_3.z;
global_3.member[_e237] = _e2059.member_4.x;
global_3.member[_e248] = _e2063.member_4.y;
global_3.member[_e259] = _e2067.member_4.z;
global_3.member[_e270] = _e2071.member_5;
let _e2135 = local_24;
global_3.member[_e281] = _e2135;
global_3.member[_e292] = f32(_e2074.member_7);
global_3.member[_e303] = _e2078.member_8;
global_3.member[_e314] = _e2081.member_9;
global_3.member[_e325] = _e2084.member_10;
global_3.member[_e336] = _e2087.member_11;
global_3.member[_e347] = f32(_e2090.member_12);
global_3.member[_e358] = f32(_e2094.member_13);
global_3.member[_e369] = _e2098.member_14;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
