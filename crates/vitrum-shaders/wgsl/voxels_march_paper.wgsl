struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_5 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: type_4,
member_4: type_4,
member_5: type_4,
member_6: type_4,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: vec4<u32>,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: vec4<u32>,
member_25: type_4,
member_26: type_4,
member_27: type_4,
member_28: type_4,
}
struct type_6 {
member: type_5,
}
struct type_8 {
member: array<f32>,
}
struct type_11 {
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
struct type_13 {
member: array<u32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_6;
@group(0) @binding(4)
var<storage> global_2: type_8;
@group(0) @binding(5)
var<storage, read_write> global_3: type_8;
@group(0) @binding(1)
var<storage> global_4: type_13;
@group(0) @binding(2)
var<storage> global_5: type_13;
@group(0) @binding(3)
var<storage> global_6: type_8;
fn function_() {
var phi_632_: u32;
var phi_838_: type_11;
var phi_841_: i32;
var phi_1460_: type_11;
var phi_1173_: type_11;
var phi_1461_: type_11;
var phi_2266_: type_11;
var phi_2319_: type_11;
var phi_2333_: type_11;
var phi_2772_: type_11;
var phi_2773_: type_11;
var phi_2752_: type_11;
var phi_2774_: type_11;
var phi_2783_: type_11;
var phi_2784_: type_11;
var phi_2785_: type_11;
var phi_1793_: type_11;
var phi_2786_: type_11;
var phi_839_: type_11;
var phi_842_: i32;
var local: type_11;
var local_1: type_11;
var local_2: type_11;
var local_3: type_11;
var local_4: type_11;
var local_5: type_11;
var local_6: type_11;
var local_7: type_11;
var local_8: type_11;
var local_9: type_11;
var local_10: type_11;
var local_11: type_11;
var local_12: type_11;
var local_13: type_11;
var local_14: type_11;
var local_15: type_11;
var local_16: type_11;
var local_17: type_11;
var local_18: type_11;
var local_19: type_11;
var local_20: type_11;
var local_21: type_11;
var local_22: type_11;
var local_23: type_11;
var local_24: f32;
let _e79 = global;
let _e87 = arrayLength((&global_2.member));
let _e93 = global_1.member.member[0u];
let _e97 = global_1.member.member[1u];
if (_e79.x < _e93) {
if (_e79.y < _e97) {
let _e102 = (_e93 * _e97);
let _e104 = ((_e79.y * _e93) + _e79.x);
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
phi_632_ = 3u;
} else {
phi_632_ = select(0u, 1u, (_e290 == 4f));
}
let _e383 = phi_632_;
if (_e383 > 1u) {
let _e388 = global_1.member.member[2u];
let _e419 = global_1.member.member_1[0u];
let _e420 = bitcast<i32>(_e419);
let _e424 = global_1.member.member_1[1u];
let _e425 = bitcast<i32>(_e424);
let _e429 = global_1.member.member_1[2u];
let _e430 = bitcast<i32>(_e429);
phi_838_ = type_11(vec3<f32>(_e115, _e125, _e136), vec3<f32>(_e147, _e158, _e169), vec3<f32>(_e180, _e191, _e202), vec3<f32>(_e213, _e224, _e235), vec3<f32>(_e246, _e257, _e268), _e279, _e290, select(0i, select(select(i32(_e301), i32(-2147483648), (_e301 < -2147483600f)), 2147483647i, (_e301 > 2147483500f)), (_e301 == _e301)), _e312, _e323, _e334, _e345, select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < -2147483600f)), 2147483647i, (_e356 > 2147483500f)), (_e356 == _e356)), select(0i, select(select(i32(_e367), i32(-2147483648), (_e367 < -2147483600f)), 2147483647i, (_e367 > 2147483500f)), (_e367 == _e367)), _e378);
phi_841_ = 0i;
loop {
let _e435 = phi_838_;
let _e437 = phi_841_;
local = _e435;
local_1 = _e435;
local_2 = _e435;
local_3 = _e435;
local_4 = _e435;
local_5 = _e435;
local_6 = _e435;
local_7 = _e435;
local_8 = _e435;
local_9 = _e435;
local_10 = _e435;
local_11 = _e435;
local_12 = _e435;
local_13 = _e435;
local_14 = _e435;
local_15 = _e435;
local_16 = _e435;
local_17 = _e435;
local_18 = _e435;
local_19 = _e435;
local_20 = _e435;
local_21 = _e435;
local_22 = _e435;
local_23 = _e435;
let _e441 = ((_e437 < 256i) && (_e435.member_6 == 0f));
local_24 = _e435.member_6;
if _e441 {
let _e447 = bitcast<f32>((bitcast<u32>(_e435.member_1.x) & 2147483647u));
let _e451 = bitcast<f32>((bitcast<u32>(_e435.member_1.y) & 2147483647u));
let _e453 = select(_e451, _e447, (_e447 > _e451));
let _e457 = bitcast<f32>((bitcast<u32>(_e435.member_1.z) & 2147483647u));
let _e459 = select(_e457, _e453, (_e453 > _e457));
let _e462 = (1f / select(0.5f, _e459, (_e459 > 0.5f)));
let _e464 = (_e435.member_14 <= _e462);
if _e464 {
let _e794 = type_11(vec3<f32>((_e435.member.x + (_e435.member_1.x * _e435.member_14)), (_e435.member.y + (_e435.member_1.y * _e435.member_14)), (_e435.member.z + (_e435.member_1.z * _e435.member_14))), _e435.member_1, _e435.member_2, _e435.member_3, _e435.member_4, _e435.member_5, _e435.member_6, _e435.member_7, _e435.member_8, _e435.member_9, _e435.member_10, _e435.member_11, _e435.member_12, _e435.member_13, _e435.member_14);
let _e811 = type_11(_e794.member, _e794.member_1, _e794.member_2, _e794.member_3, _e794.member_4, (_e435.member_5 + _e435.member_14), _e794.member_6, _e794.member_7, _e794.member_8, _e794.member_9, _e794.member_10, _e794.member_11, _e794.member_12, _e794.member_13, _e794.member_14);
let _e827 = type_11(_e811.member, _e811.member_1, _e811.member_2, _e811.member_3, _e811.member_4, _e811.member_5, _e811.member_6, _e811.member_7, _e811.member_8, _e811.member_9, _e811.member_10, _e811.member_11, _e811.member_12, _e811.member_13, (_e435.member_14 - _e435.member_14));
let _e847 = type_11(_e827.member, _e827.member_1, _e827.member_2, _e827.member_3, _e827.member_4, _e827.member_5, _e827.member_6, _e827.member_7, _e827.member_8, _e827.member_9, (_e435.member_10 + select(0f, _e435.member_14, (_e435.member_8 == 0f))), _e827.member_11, _e827.member_12, _e827.member_13, _e827.member_14);
if (_e435.member_7 != 16i) {
let _e865 = type_11(_e847.member, _e847.member_1, _e847.member_2, _e847.member_3, _e847.member_4, _e847.member_5, _e847.member_6, _e847.member_7, _e847.member_8, (_e435.member_9 + _e435.member_14), _e847.member_10, _e847.member_11, _e847.member_12, _e847.member_13, _e847.member_14);
let _e866 = (_e435.member_7 * 4i);
let _e867 = (_e866 + 1i);
let _e869 = (bitcast<i32>(_e87) - 1i);
let _e871 = select(_e869, _e867, (_e867 < _e869));
let _e877 = global_2.member[bitcast<u32>(select(0i, _e871, (_e871 > 0i)))];
let _e879 = -((_e877 * _e435.member_14));
let _e881 = select(-87f, _e879, (_e879 > -87f));
let _e883 = select(88f, _e881, (_e881 < 88f));
let _e885 = ((_e883 * 1.442695f) + 0.5f);
let _e887 = select(-127f, _e885, (_e885 > -127f));
let _e889 = select(128f, _e887, (_e887 < 128f));
let _e896 = select(0i, select(select(i32(_e889), i32(-2147483648), (_e889 < -2147483600f)), 2147483647i, (_e889 > 2147483500f)), (_e889 == _e889));
let _e900 = (_e896 - select(0i, 1i, (_e889 < f32(_e896))));
let _e901 = f32(_e900);
let _e905 = ((_e883 - (_e901 * 0.6933594f)) - (_e901 * -2.1219444e-4f));
let _e929 = (_e866 + 2i);
let _e931 = select(_e869, _e929, (_e929 < _e869));
let _e937 = global_2.member[bitcast<u32>(select(0i, _e931, (_e931 > 0i)))];
let _e939 = -((_e937 * _e435.member_14));
let _e941 = select(-87f, _e939, (_e939 > -87f));
let _e943 = select(88f, _e941, (_e941 < 88f));
let _e945 = ((_e943 * 1.442695f) + 0.5f);
let _e947 = select(-127f, _e945, (_e945 > -127f));
let _e949 = select(128f, _e947, (_e947 < 128f));
let _e956 = select(0i, select(select(i32(_e949), i32(-2147483648), (_e949 < -2147483600f)), 2147483647i, (_e949 > 2147483500f)), (_e949 == _e949));
let _e960 = (_e956 - select(0i, 1i, (_e949 < f32(_e956))));
let _e961 = f32(_e960);
let _e965 = ((_e943 - (_e961 * 0.6933594f)) - (_e961 * -2.1219444e-4f));
let _e989 = (_e866 + 3i);
let _e991 = select(_e869, _e989, (_e989 < _e869));
let _e997 = global_2.member[bitcast<u32>(select(0i, _e991, (_e991 > 0i)))];
let _e999 = -((_e997 * _e435.member_14));
let _e1001 = select(-87f, _e999, (_e999 > -87f));
let _e1003 = select(88f, _e1001, (_e1001 < 88f));
let _e1005 = ((_e1003 * 1.442695f) + 0.5f);
let _e1007 = select(-127f, _e1005, (_e1005 > -127f));
let _e1009 = select(128f, _e1007, (_e1007 < 128f));
let _e1016 = select(0i, select(select(i32(_e1009), i32(-2147483648), (_e1009 < -2147483600f)), 2147483647i, (_e1009 > 2147483500f)), (_e1009 == _e1009));
let _e1020 = (_e1016 - select(0i, 1i, (_e1009 < f32(_e1016))));
let _e1021 = f32(_e1020);
let _e1025 = ((_e1003 - (_e1021 * 0.6933594f)) - (_e1021 * -2.1219444e-4f));
phi_1173_ = type_11(_e865.member, _e865.member_1, vec3<f32>((_e435.member_2.x * ((1f + (_e905 * (1f + (_e905 * (0.5f + (_e905 * (0.16666667f + (_e905 * (0.041666668f + (_e905 * (0.008333334f + (_e905 * (0.001388889f + (_e905 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e900 + 127i)) << bitcast<u32>(23i))))), (_e435.member_2.y * ((1f + (_e965 * (1f + (_e965 * (0.5f + (_e965 * (0.16666667f + (_e965 * (0.041666668f + (_e965 * (0.008333334f + (_e965 * (0.001388889f + (_e965 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e960 + 127i)) << bitcast<u32>(23i))))), (_e435.member_2.z * ((1f + (_e1025 * (1f + (_e1025 * (0.5f + (_e1025 * (0.16666667f + (_e1025 * (0.041666668f + (_e1025 * (0.008333334f + (_e1025 * (0.001388889f + (_e1025 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1020 + 127i)) << bitcast<u32>(23i)))))), _e865.member_3, _e865.member_4, _e865.member_5, _e865.member_6, _e865.member_7, _e865.member_8, _e865.member_9, _e865.member_10, _e865.member_11, _e865.member_12, _e865.member_13, _e865.member_14);
} else {
phi_1173_ = _e847;
}
let _e1066 = phi_1173_;
phi_1461_ = type_11(_e1066.member, _e1066.member_1, _e1066.member_2, _e1066.member_3, _e1066.member_4, _e1066.member_5, 3f, _e1066.member_7, _e1066.member_8, _e1066.member_9, _e1066.member_10, _e1066.member_11, _e1066.member_12, _e1066.member_13, _e1066.member_14);
} else {
let _e493 = type_11(vec3<f32>((_e435.member.x + (_e435.member_1.x * _e462)), (_e435.member.y + (_e435.member_1.y * _e462)), (_e435.member.z + (_e435.member_1.z * _e462))), _e435.member_1, _e435.member_2, _e435.member_3, _e435.member_4, _e435.member_5, _e435.member_6, _e435.member_7, _e435.member_8, _e435.member_9, _e435.member_10, _e435.member_11, _e435.member_12, _e435.member_13, _e435.member_14);
let _e510 = type_11(_e493.member, _e493.member_1, _e493.member_2, _e493.member_3, _e493.member_4, (_e435.member_5 + _e462), _e493.member_6, _e493.member_7, _e493.member_8, _e493.member_9, _e493.member_10, _e493.member_11, _e493.member_12, _e493.member_13, _e493.member_14);
let _e526 = type_11(_e510.member, _e510.member_1, _e510.member_2, _e510.member_3, _e510.member_4, _e510.member_5, _e510.member_6, _e510.member_7, _e510.member_8, _e510.member_9, _e510.member_10, _e510.member_11, _e510.member_12, _e510.member_13, (_e435.member_14 - _e462));
let _e546 = type_11(_e526.member, _e526.member_1, _e526.member_2, _e526.member_3, _e526.member_4, _e526.member_5, _e526.member_6, _e526.member_7, _e526.member_8, _e526.member_9, (_e435.member_10 + select(0f, _e462, (_e435.member_8 == 0f))), _e526.member_11, _e526.member_12, _e526.member_13, _e526.member_14);
if (_e435.member_7 != 16i) {
let _e564 = type_11(_e546.member, _e546.member_1, _e546.member_2, _e546.member_3, _e546.member_4, _e546.member_5, _e546.member_6, _e546.member_7, _e546.member_8, (_e435.member_9 + _e462), _e546.member_10, _e546.member_11, _e546.member_12, _e546.member_13, _e546.member_14);
let _e565 = (_e435.member_7 * 4i);
let _e566 = (_e565 + 1i);
let _e568 = (bitcast<i32>(_e87) - 1i);
let _e570 = select(_e568, _e566, (_e566 < _e568));
let _e576 = global_2.member[bitcast<u32>(select(0i, _e570, (_e570 > 0i)))];
let _e578 = -((_e576 * _e462));
let _e580 = select(-87f, _e578, (_e578 > -87f));
let _e582 = select(88f, _e580, (_e580 < 88f));
let _e584 = ((_e582 * 1.442695f) + 0.5f);
let _e586 = select(-127f, _e584, (_e584 > -127f));
let _e588 = select(128f, _e586, (_e586 < 128f));
let _e595 = select(0i, select(select(i32(_e588), i32(-2147483648), (_e588 < -2147483600f)), 2147483647i, (_e588 > 2147483500f)), (_e588 == _e588));
let _e599 = (_e595 - select(0i, 1i, (_e588 < f32(_e595))));
let _e600 = f32(_e599);
let _e604 = ((_e582 - (_e600 * 0.6933594f)) - (_e600 * -2.1219444e-4f));
let _e628 = (_e565 + 2i);
let _e630 = select(_e568, _e628, (_e628 < _e568));
let _e636 = global_2.member[bitcast<u32>(select(0i, _e630, (_e630 > 0i)))];
let _e638 = -((_e636 * _e462));
let _e640 = select(-87f, _e638, (_e638 > -87f));
let _e642 = select(88f, _e640, (_e640 < 88f));
let _e644 = ((_e642 * 1.442695f) + 0.5f);
let _e646 = select(-127f, _e644, (_e644 > -127f));
let _e648 = select(128f, _e646, (_e646 < 128f));
let _e655 = select(0i, select(select(i32(_e648), i32(-2147483648), (_e648 < -2147483600f)), 2147483647i, (_e648 > 2147483500f)), (_e648 == _e648));
let _e659 = (_e655 - select(0i, 1i, (_e648 < f32(_e655))));
let _e660 = f32(_e659);
let _e664 = ((_e642 - (_e660 * 0.6933594f)) - (_e660 * -2.1219444e-4f));
let _e688 = (_e565 + 3i);
let _e690 = select(_e568, _e688, (_e688 < _e568));
let _e696 = global_2.member[bitcast<u32>(select(0i, _e690, (_e690 > 0i)))];
let _e698 = -((_e696 * _e462));
let _e700 = select(-87f, _e698, (_e698 > -87f));
let _e702 = select(88f, _e700, (_e700 < 88f));
let _e704 = ((_e702 * 1.442695f) + 0.5f);
let _e706 = select(-127f, _e704, (_e704 > -127f));
let _e708 = select(128f, _e706, (_e706 < 128f));
let _e715 = select(0i, select(select(i32(_e708), i32(-2147483648), (_e708 < -2147483600f)), 2147483647i, (_e708 > 2147483500f)), (_e708 == _e708));
let _e719 = (_e715 - select(0i, 1i, (_e708 < f32(_e715))));
let _e720 = f32(_e719);
let _e724 = ((_e702 - (_e720 * 0.6933594f)) - (_e720 * -2.1219444e-4f));
phi_1460_ = type_11(_e564.member, _e564.member_1, vec3<f32>((_e435.member_2.x * ((1f + (_e604 * (1f + (_e604 * (0.5f + (_e604 * (0.16666667f + (_e604 * (0.041666668f + (_e604 * (0.008333334f + (_e604 * (0.001388889f + (_e604 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e599 + 127i)) << bitcast<u32>(23i))))), (_e435.member_2.y * ((1f + (_e664 * (1f + (_e664 * (0.5f + (_e664 * (0.16666667f + (_e664 * (0.041666668f + (_e664 * (0.008333334f + (_e664 * (0.001388889f + (_e664 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e659 + 127i)) << bitcast<u32>(23i))))), (_e435.member_2.z * ((1f + (_e724 * (1f + (_e724 * (0.5f + (_e724 * (0.16666667f + (_e724 * (0.041666668f + (_e724 * (0.008333334f + (_e724 * (0.001388889f + (_e724 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e719 + 127i)) << bitcast<u32>(23i)))))), _e564.member_3, _e564.member_4, _e564.member_5, _e564.member_6, _e564.member_7, _e564.member_8, _e564.member_9, _e564.member_10, _e564.member_11, _e564.member_12, _e564.member_13, _e564.member_14);
} else {
phi_1460_ = _e546;
}
let _e765 = phi_1460_;
phi_1461_ = _e765;
}
let _e1083 = phi_1461_;
if (!(_e464) && ((((((_e1083.member.x < 0f) || (_e1083.member.y < 0f)) || (_e1083.member.z < 0f)) || (_e1083.member.x >= f32(_e420))) || (_e1083.member.y >= f32(_e425))) || (_e1083.member.z >= f32(_e430)))) {
if (_e1083.member_13 == -1i) {
phi_1793_ = type_11(_e1083.member, _e1083.member_1, _e1083.member_2, _e1083.member_3, _e1083.member_4, _e1083.member_5, 1f, _e1083.member_7, _e1083.member_8, _e1083.member_9, _e1083.member_10, _e1083.member_11, _e1083.member_12, _e1083.member_13, _e1083.member_14);
} else {
let _e1903 = type_11(vec3<f32>((_e1083.member.x + (_e1083.member_1.x * _e1083.member_14)), (_e1083.member.y + (_e1083.member_1.y * _e1083.member_14)), (_e1083.member.z + (_e1083.member_1.z * _e1083.member_14))), _e1083.member_1, _e1083.member_2, _e1083.member_3, _e1083.member_4, _e1083.member_5, _e1083.member_6, _e1083.member_7, _e1083.member_8, _e1083.member_9, _e1083.member_10, _e1083.member_11, _e1083.member_12, _e1083.member_13, _e1083.member_14);
let _e1920 = type_11(_e1903.member, _e1903.member_1, _e1903.member_2, _e1903.member_3, _e1903.member_4, (_e1083.member_5 + _e1083.member_14), _e1903.member_6, _e1903.member_7, _e1903.member_8, _e1903.member_9, _e1903.member_10, _e1903.member_11, _e1903.member_12, _e1903.member_13, _e1903.member_14);
let _e1936 = type_11(_e1920.member, _e1920.member_1, _e1920.member_2, _e1920.member_3, _e1920.member_4, _e1920.member_5, _e1920.member_6, _e1920.member_7, _e1920.member_8, _e1920.member_9, _e1920.member_10, _e1920.member_11, _e1920.member_12, _e1920.member_13, (_e1083.member_14 - _e1083.member_14));
let _e1956 = type_11(_e1936.member, _e1936.member_1, _e1936.member_2, _e1936.member_3, _e1936.member_4, _e1936.member_5, _e1936.member_6, _e1936.member_7, _e1936.member_8, _e1936.member_9, (_e1083.member_10 + select(0f, _e1083.member_14, (_e1083.member_8 == 0f))), _e1936.member_11, _e1936.member_12, _e1936.member_13, _e1936.member_14);
phi_1793_ = type_11(_e1956.member, _e1956.member_1, _e1956.member_2, _e1956.member_3, _e1956.member_4, _e1956.member_5, 3f, _e1956.member_7, _e1956.member_8, _e1956.member_9, _e1956.member_10, _e1956.member_11, _e1956.member_12, _e1956.member_13, _e1956.member_14);
}
let _e1988 = phi_1793_;
phi_2786_ = _e1988;
} else {
if _e464 {
phi_2785_ = _e1083;
} else {
let _e1105 = f32((_e420 - 1i));
let _e1107 = select(0f, _e1083.member.x, (_e1083.member.x > 0f));
let _e1109 = select(_e1105, _e1107, (_e1107 < _e1105));
let _e1116 = select(0i, select(select(i32(_e1109), i32(-2147483648), (_e1109 < -2147483600f)), 2147483647i, (_e1109 > 2147483500f)), (_e1109 == _e1109));
let _e1120 = (_e1116 - select(0i, 1i, (_e1109 < f32(_e1116))));
let _e1122 = f32((_e425 - 1i));
let _e1124 = select(0f, _e1083.member.y, (_e1083.member.y > 0f));
let _e1126 = select(_e1122, _e1124, (_e1124 < _e1122));
let _e1133 = select(0i, select(select(i32(_e1126), i32(-2147483648), (_e1126 < -2147483600f)), 2147483647i, (_e1126 > 2147483500f)), (_e1126 == _e1126));
let _e1139 = f32((_e430 - 1i));
let _e1141 = select(0f, _e1083.member.z, (_e1083.member.z > 0f));
let _e1143 = select(_e1139, _e1141, (_e1141 < _e1139));
let _e1150 = select(0i, select(select(i32(_e1143), i32(-2147483648), (_e1143 < -2147483600f)), 2147483647i, (_e1143 > 2147483500f)), (_e1143 == _e1143));
let _e1160 = (((((_e1150 - select(0i, 1i, (_e1143 < f32(_e1150)))) * _e425) + (_e1133 - select(0i, 1i, (_e1126 < f32(_e1133))))) * ((_e420 + 31i) >> bitcast<u32>(5i))) + (_e1120 >> bitcast<u32>(5i)));
let _e1162 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1164 = select(_e1162, _e1160, (_e1160 < _e1162));
let _e1170 = global_4.member[bitcast<u32>(select(0i, _e1164, (_e1164 > 0i)))];
let _e1173 = (bitcast<u32>((_e1120 & 31i)) & 31u);
if (((_e1170 >> bitcast<u32>(_e1173)) & 1u) == 1u) {
let _e1179 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1181 = select(_e1179, _e1160, (_e1160 < _e1179));
let _e1187 = global_5.member[bitcast<u32>(select(0i, _e1181, (_e1181 > 0i)))];
let _e1195 = (bitcast<i32>((_e1187 + countOneBits((_e1170 & ((1u << bitcast<u32>(_e1173)) - 1u))))) * 4i);
let _e1197 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e1199 = select(_e1197, _e1195, (_e1195 < _e1197));
let _e1205 = global_6.member[bitcast<u32>(select(0i, _e1199, (_e1199 > 0i)))];
let _e1206 = (_e1195 + 1i);
let _e1208 = select(_e1197, _e1206, (_e1206 < _e1197));
let _e1214 = global_6.member[bitcast<u32>(select(0i, _e1208, (_e1208 > 0i)))];
let _e1215 = (_e1195 + 2i);
let _e1217 = select(_e1197, _e1215, (_e1215 < _e1197));
let _e1223 = global_6.member[bitcast<u32>(select(0i, _e1217, (_e1217 > 0i)))];
let _e1224 = vec3<f32>(_e1205, _e1214, _e1223);
let _e1225 = (_e1195 + 3i);
let _e1227 = select(_e1197, _e1225, (_e1225 < _e1197));
let _e1233 = global_6.member[bitcast<u32>(select(0i, _e1227, (_e1227 > 0i)))];
let _e1235 = select(0f, _e1233, (_e1233 > 0f));
let _e1237 = select(16f, _e1235, (_e1235 < 16f));
let _e1244 = select(0i, select(select(i32(_e1237), i32(-2147483648), (_e1237 < -2147483600f)), 2147483647i, (_e1237 > 2147483500f)), (_e1237 == _e1237));
let _e1253 = (((_e435.member_1.x * _e1205) + (_e435.member_1.y * _e1214)) + (_e435.member_1.z * _e1223));
let _e1255 = select(16i, (_e1244 - select(0i, 1i, (_e1237 < f32(_e1244)))), (_e1253 < 0f));
let _e1270 = global_1.member.member_7.member_1;
if ((!(((_e1083.member_8 > 0f) && ((((_e1205 * _e1083.member_4.x) + (_e1214 * _e1083.member_4.y)) + (_e1223 * _e1083.member_4.z)) > _e1270))) && (_e1253 != 0f)) && (_e1255 != _e1083.member_7)) {
let _e1280 = (_e1083.member_7 * 4i);
let _e1282 = (bitcast<i32>(_e87) - 1i);
let _e1284 = select(_e1282, _e1280, (_e1280 < _e1282));
let _e1290 = global_2.member[bitcast<u32>(select(0i, _e1284, (_e1284 > 0i)))];
let _e1292 = select(_e1290, 1f, (_e1083.member_7 == 16i));
let _e1293 = (_e1255 * 4i);
let _e1295 = select(_e1282, _e1293, (_e1293 < _e1282));
let _e1301 = global_2.member[bitcast<u32>(select(0i, _e1295, (_e1295 > 0i)))];
let _e1303 = select(_e1301, 1f, (_e1255 == 16i));
let _e1313 = select(1f, -1f, ((((_e1083.member_1.x * _e1205) + (_e1083.member_1.y * _e1214)) + (_e1083.member_1.z * _e1223)) > 0f));
let _e1314 = (_e1205 * _e1313);
let _e1315 = (_e1214 * _e1313);
let _e1316 = (_e1223 * _e1313);
let _e1322 = -((((_e1083.member_1.x * _e1314) + (_e1083.member_1.y * _e1315)) + (_e1083.member_1.z * _e1316)));
let _e1324 = select(0f, _e1322, (_e1322 > 0f));
let _e1325 = (_e1292 / _e1303);
let _e1327 = (_e1324 * _e1324);
let _e1330 = (1f - ((_e1325 * _e1325) * (1f - _e1327)));
let _e1331 = (_e1330 <= 0f);
let _e1339 = ((_e1325 * _e1324) - sqrt(select(0f, _e1330, (_e1330 > 0f))));
let _e1346 = (2f * _e1324);
let _e1353 = select(((_e1083.member_1.x * _e1325) + (_e1314 * _e1339)), (_e1083.member_1.x + (_e1314 * _e1346)), _e1331);
let _e1354 = select(((_e1083.member_1.y * _e1325) + (_e1315 * _e1339)), (_e1083.member_1.y + (_e1315 * _e1346)), _e1331);
let _e1355 = select(((_e1083.member_1.z * _e1325) + (_e1316 * _e1339)), (_e1083.member_1.z + (_e1316 * _e1346)), _e1331);
let _e1360 = (((_e1353 * _e1353) + (_e1354 * _e1354)) + (_e1355 * _e1355));
let _e1363 = sqrt(select(0f, _e1360, (_e1360 > 0f)));
let _e1366 = (1f / select(1e-20f, _e1363, (_e1363 > 1e-20f)));
let _e1371 = (_e1303 / _e1292);
let _e1374 = (((_e1371 * _e1371) - 1f) + _e1327);
let _e1377 = sqrt(select(0f, _e1374, (_e1374 > 0f)));
let _e1378 = (_e1377 - _e1324);
let _e1379 = (_e1377 + _e1324);
let _e1382 = (_e1378 / select(1e-6f, _e1379, (_e1379 > 1e-6f)));
let _e1386 = ((_e1324 * _e1378) + 1f);
let _e1389 = (((_e1324 * _e1379) - 1f) / select(1e-6f, _e1386, (_e1386 > 1e-6f)));
let _e1403 = global_1.member.member[3u];
let _e1406 = select(0f, select(select((((0.5f * _e1382) * _e1382) * (1f + (_e1389 * _e1389))), 1f, (_e1374 <= 0f)), 0f, (_e1292 == _e1303)), ((_e1403 & 1u) != 0u));
if (_e1083.member_8 == 0f) {
let _e1421 = type_11(_e1083.member, _e1083.member_1, _e1083.member_2, _e1224, _e1083.member_4, _e1083.member_5, _e1083.member_6, _e1083.member_7, _e1083.member_8, _e1083.member_9, _e1083.member_10, _e1083.member_11, _e1083.member_12, _e1083.member_13, _e1083.member_14);
phi_2266_ = type_11(_e1421.member, _e1421.member_1, _e1421.member_2, _e1421.member_3, _e1421.member_4, _e1421.member_5, _e1421.member_6, _e1421.member_7, _e1421.member_8, _e1421.member_9, _e1421.member_10, _e1406, _e1421.member_12, _e1421.member_13, _e1421.member_14);
} else {
phi_2266_ = _e1083;
}
let _e1438 = phi_2266_;
let _e1440 = (_e1438.member_8 + 1f);
let _e1455 = type_11(_e1438.member, _e1438.member_1, _e1438.member_2, _e1438.member_3, _e1438.member_4, _e1438.member_5, _e1438.member_6, _e1438.member_7, _e1440, _e1438.member_9, _e1438.member_10, _e1438.member_11, _e1438.member_12, _e1438.member_13, _e1438.member_14);
let _e1458 = ((_e388 == 0u) && (_e1440 >= 2f));
if (_e1331 && _e1458) {
let _e1483 = (((_e1438.member_1.x * _e1205) + (_e1438.member_1.y * _e1214)) + (_e1438.member_1.z * _e1223));
let _e1487 = (_e1438.member_1.x - (_e1205 * _e1483));
let _e1488 = (_e1438.member_1.y - (_e1214 * _e1483));
let _e1489 = (_e1438.member_1.z - (_e1223 * _e1483));
let _e1494 = (((_e1487 * _e1487) + (_e1488 * _e1488)) + (_e1489 * _e1489));
let _e1497 = sqrt(select(0f, _e1494, (_e1494 > 0f)));
let _e1500 = (1f / select(1e-20f, _e1497, (_e1497 > 1e-20f)));
phi_2319_ = type_11(_e1455.member, vec3<f32>((_e1487 * _e1500), (_e1488 * _e1500), (_e1489 * _e1500)), _e1455.member_2, _e1455.member_3, _e1455.member_4, _e1455.member_5, _e1455.member_6, _e1455.member_7, _e1455.member_8, _e1455.member_9, _e1455.member_10, _e1455.member_11, _e1455.member_12, _e1455.member_13, _e1455.member_14);
} else {
phi_2319_ = type_11(_e1455.member, vec3<f32>((_e1353 * _e1366), (_e1354 * _e1366), (_e1355 * _e1366)), _e1455.member_2, _e1455.member_3, _e1455.member_4, _e1455.member_5, _e1455.member_6, _e1455.member_7, _e1455.member_8, _e1455.member_9, _e1455.member_10, _e1455.member_11, _e1455.member_12, _e1455.member_13, _e1455.member_14);
}
let _e1521 = phi_2319_;
if _e1331 {
phi_2333_ = _e1521;
} else {
let _e1522 = (1f - _e1406);
phi_2333_ = type_11(_e1521.member, _e1521.member_1, vec3<f32>((_e1521.member_2.x * _e1522), (_e1521.member_2.y * _e1522), (_e1521.member_2.z * _e1522)), _e1521.member_3, _e1521.member_4, _e1521.member_5, _e1521.member_6, _e1521.member_7, _e1521.member_8, _e1521.member_9, _e1521.member_10, _e1521.member_11, _e1521.member_12, _e1521.member_13, _e1521.member_14);
}
let _e1549 = phi_2333_;
let _e1554 = global_1.member.member_17;
let _e1567 = ((((_e1554.member * _e1549.member.x) + (_e1554.member_1 * _e1549.member.y)) + (_e1554.member_2 * _e1549.member.z)) + _e1554.member_3);
let _e1576 = -((((_e1554.member * _e1549.member_1.x) + (_e1554.member_1 * _e1549.member_1.y)) + (_e1554.member_2 * _e1549.member_1.z)));
let _e1578 = (_e1576 > 1e-9f);
let _e1582 = ((_e1567 / select(1e-9f, _e1576, _e1578)) - 0.015625f);
let _e1585 = select(1e30f, select(0f, _e1582, (_e1582 > 0f)), ((_e1567 > 0f) && _e1578));
let _e1588 = global_1.member.member_19;
let _e1598 = ((((_e1588.member * _e1549.member.x) + (_e1588.member_1 * _e1549.member.y)) + (_e1588.member_2 * _e1549.member.z)) + _e1588.member_3);
let _e1604 = -((((_e1588.member * _e1549.member_1.x) + (_e1588.member_1 * _e1549.member_1.y)) + (_e1588.member_2 * _e1549.member_1.z)));
let _e1606 = (_e1604 > 1e-9f);
let _e1610 = ((_e1598 / select(1e-9f, _e1604, _e1606)) - 0.015625f);
let _e1613 = select(1e30f, select(0f, _e1610, (_e1610 > 0f)), ((_e1598 > 0f) && _e1606));
let _e1617 = (_e1613 < _e1585);
let _e1619 = select(select(-2i, -3i, _e1617), -1i, ((_e1585 >= 1e30f) && (_e1613 >= 1e30f)));
let _e1620 = select(_e1585, _e1613, _e1617);
let _e1635 = type_11(_e1549.member, _e1549.member_1, _e1549.member_2, _e1549.member_3, _e1549.member_4, _e1549.member_5, _e1549.member_6, _e1549.member_7, _e1549.member_8, _e1549.member_9, _e1549.member_10, _e1549.member_11, 0i, _e1549.member_13, _e1549.member_14);
let _e1650 = type_11(_e1635.member, _e1635.member_1, _e1635.member_2, _e1635.member_3, _e1635.member_4, _e1635.member_5, _e1635.member_6, _e1635.member_7, _e1635.member_8, _e1635.member_9, _e1635.member_10, _e1635.member_11, _e1635.member_12, _e1619, _e1635.member_14);
let _e1665 = type_11(_e1650.member, _e1650.member_1, _e1650.member_2, _e1650.member_3, _e1650.member_4, _e1650.member_5, _e1650.member_6, _e1650.member_7, _e1650.member_8, _e1650.member_9, _e1650.member_10, _e1650.member_11, _e1650.member_12, _e1650.member_13, _e1620);
let _e1668 = ((_e1403 & 2u) != 0u);
if (_e1458 && !(_e1668)) {
if (_e1619 == -1i) {
phi_2752_ = type_11(_e1665.member, _e1665.member_1, _e1665.member_2, _e1665.member_3, _e1665.member_4, _e1665.member_5, 1f, _e1665.member_7, _e1665.member_8, _e1665.member_9, _e1665.member_10, _e1665.member_11, _e1665.member_12, _e1665.member_13, _e1665.member_14);
} else {
let _e1745 = type_11(vec3<f32>((_e1549.member.x + (_e1549.member_1.x * _e1620)), (_e1549.member.y + (_e1549.member_1.y * _e1620)), (_e1549.member.z + (_e1549.member_1.z * _e1620))), _e1665.member_1, _e1665.member_2, _e1665.member_3, _e1665.member_4, _e1665.member_5, _e1665.member_6, _e1665.member_7, _e1665.member_8, _e1665.member_9, _e1665.member_10, _e1665.member_11, _e1665.member_12, _e1665.member_13, _e1665.member_14);
let _e1761 = type_11(_e1745.member, _e1745.member_1, _e1745.member_2, _e1745.member_3, _e1745.member_4, _e1745.member_5, _e1745.member_6, _e1745.member_7, _e1745.member_8, _e1745.member_9, _e1745.member_10, _e1745.member_11, _e1745.member_12, _e1745.member_13, (_e1620 - _e1620));
let _e1781 = type_11(_e1761.member, _e1761.member_1, _e1761.member_2, _e1761.member_3, _e1761.member_4, _e1761.member_5, _e1761.member_6, _e1761.member_7, _e1761.member_8, _e1761.member_9, (_e1549.member_10 + select(0f, _e1620, (_e1549.member_8 == 0f))), _e1761.member_11, _e1761.member_12, _e1761.member_13, _e1761.member_14);
phi_2752_ = type_11(_e1781.member, _e1781.member_1, _e1781.member_2, _e1781.member_3, _e1781.member_4, _e1781.member_5, 3f, _e1781.member_7, _e1781.member_8, _e1781.member_9, _e1781.member_10, _e1781.member_11, _e1781.member_12, _e1781.member_13, _e1781.member_14);
}
let _e1813 = phi_2752_;
phi_2774_ = _e1813;
} else {
let _e1676 = global_1.member.member_2[3u];
if ((!(_e1458) && (_e1549.member_8 >= f32(bitcast<i32>(_e1676)))) && (select(_e1255, _e1083.member_7, _e1331) != 16i)) {
phi_2773_ = type_11(_e1665.member, _e1665.member_1, _e1665.member_2, _e1665.member_3, _e1665.member_4, _e1665.member_5, 2f, _e1665.member_7, _e1665.member_8, _e1665.member_9, _e1665.member_10, _e1665.member_11, _e1665.member_12, _e1665.member_13, _e1665.member_14);
} else {
if _e1668 {
phi_2772_ = type_11(_e1665.member, _e1665.member_1, _e1665.member_2, _e1665.member_3, _e1665.member_4, _e1665.member_5, 4f, _e1665.member_7, _e1665.member_8, _e1665.member_9, _e1665.member_10, _e1665.member_11, _e1665.member_12, _e1665.member_13, _e1665.member_14);
} else {
phi_2772_ = _e1665;
}
let _e1699 = phi_2772_;
phi_2773_ = _e1699;
}
let _e1716 = phi_2773_;
phi_2774_ = _e1716;
}
let _e1815 = phi_2774_;
let _e1832 = type_11(_e1815.member, _e1815.member_1, _e1815.member_2, _e1815.member_3, _e1815.member_4, _e1815.member_5, _e1815.member_6, select(_e1083.member_7, _e1255, !(_e1331)), _e1815.member_8, _e1815.member_9, _e1815.member_10, _e1815.member_11, _e1815.member_12, _e1815.member_13, _e1815.member_14);
let _e1847 = type_11(_e1832.member, _e1832.member_1, _e1832.member_2, _e1832.member_3, _e1224, _e1832.member_5, _e1832.member_6, _e1832.member_7, _e1832.member_8, _e1832.member_9, _e1832.member_10, _e1832.member_11, _e1832.member_12, _e1832.member_13, _e1832.member_14);
phi_2783_ = type_11(_e1847.member, _e1847.member_1, _e1847.member_2, _e1847.member_3, _e1847.member_4, 0f, _e1847.member_6, _e1847.member_7, _e1847.member_8, _e1847.member_9, _e1847.member_10, _e1847.member_11, _e1847.member_12, _e1847.member_13, _e1847.member_14);
} else {
phi_2783_ = _e1083;
}
let _e1864 = phi_2783_;
phi_2784_ = _e1864;
} else {
phi_2784_ = _e1083;
}
let _e1866 = phi_2784_;
phi_2785_ = _e1866;
}
let _e1868 = phi_2785_;
phi_2786_ = _e1868;
}
let _e1990 = phi_2786_;
phi_839_ = _e1990;
phi_842_ = (_e437 + 1i);
} else {
phi_839_ = type_11();
phi_842_ = i32();
}
let _e1992 = phi_839_;
let _e1994 = phi_842_;
continue;
continuing {
phi_838_ = _e1992;
phi_841_ = _e1994;
break if !(_e441);
}
}
let _e1997 = local;
let _e2001 = local_1;
let _e2005 = local_2;
let _e2009 = local_3;
let _e2013 = local_4;
let _e2017 = local_5;
let _e2021 = local_6;
let _e2025 = local_7;
let _e2029 = local_8;
let _e2033 = local_9;
let _e2037 = local_10;
let _e2041 = local_11;
let _e2045 = local_12;
let _e2049 = local_13;
let _e2053 = local_14;
let _e2057 = local_15;
let _e2060 = local_16;
let _e2064 = local_17;
let _e2067 = local_18;
let _e2070 = local_19;
let _e2073 = local_20;
let _e2076 = local_21;
let _e2080 = local_22;
let _e2084 = local_23;
global_3.member[_e104] = _e1997.member.x;
global_3.member[_e116] = _e2001.member.y;
global_3.member[_e127] = _e2005.member.z;
global_3.member[_e138] = _e2009.member_1.x;
global_3.member[_e149] = _e2013.member_1.y;
global_3.member[_e160] = _e2017.member_1.z;
global_3.member[_e171] = _e2021.member_2.x;
global_3.member[_e182] = _e2025.member_2.y;
global_3.member[_e193] = _e2029.member_2.z;
global_3.member[_e204] = _e2033.member_3.x;
global_3.member[_e215] = _e2037.member_3.y;
global_3.member[_e226] = _e2041.member_3.z;
global_3.member[_e237] = _e2045.member_4.x;
global_3.member[_e248] = _e2049.member_4.y;
global_3.member[_e259] = _e2053.member_4.z;
global_3.member[_e270] = _e2057.member_5;
let _e2121 = local_24;
global_3.member[_e281] = _e2121;
global_3.member[_e292] = f32(_e2060.member_7);
global_3.member[_e303] = _e2064.member_8;
global_3.member[_e314] = _e2067.member_9;
global_3.member[_e325] = _e2070.member_10;
global_3.member[_e336] = _e2073.member_11;
global_3.member[_e347] = f32(_e2076.member_12);
global_3.member[_e358] = f32(_e2080.member_13);
global_3.member[_e369] = _e2084.member_14;
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
