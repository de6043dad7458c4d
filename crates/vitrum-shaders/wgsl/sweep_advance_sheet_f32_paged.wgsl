struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_11 {
member: array<u32>,
}
struct type_13 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_14 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_13,
member_6: type_13,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: type_4,
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
member_24: type_4,
member_25: vec4<u32>,
member_26: type_4,
member_27: type_4,
member_28: type_4,
member_29: type_4,
member_30: type_4,
member_31: type_4,
}
struct type_15 {
member: type_14,
}
struct type_18 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_19 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_20 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_15;
@group(0) @binding(1)
var<storage> global_2: type_11;
@group(0) @binding(3)
var<storage> global_3: type_11;
@group(0) @binding(4)
var<storage> global_4: type_11;
@group(0) @binding(5)
var<storage> global_5: type_6;
@group(0) @binding(6)
var<storage, read_write> global_6: type_6;
fn function_() {
var local: type_18;
var local_1: vec3<f32>;
var local_2: type_18;
var local_3: vec3<f32>;
var local_4: type_18;
var local_5: vec3<f32>;
var phi_5835_: type_19;
var phi_7155_: type_20;
var phi_8676_: type_21;
var phi_9700_: f32;
var phi_9701_: f32;
var phi_9702_: f32;
var phi_9703_: bool;
switch bitcast<i32>(0u) {
default: {
let _e88 = global;
let _e91 = arrayLength((&global_2.member));
let _e95 = arrayLength((&global_4.member));
let _e102 = global_1.member.member_1;
let _e105 = (_e88.x + _e102.x);
let _e108 = (_e88.y + _e102.y);
if (_e105 < _e102.z) {
if (_e108 < _e102.w) {
let _e116 = global_1.member.member[0u];
let _e120 = global_1.member.member[1u];
let _e121 = (_e116 * _e120);
let _e123 = ((_e108 * _e116) + _e105);
let _e124 = bitcast<i32>(_e123);
let _e126 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e128 = select(_e126, _e124, (_e124 < _e126));
let _e134 = global_6.member[bitcast<u32>(select(0i, _e128, (_e128 > 0i)))];
let _e135 = (_e121 + _e123);
let _e136 = bitcast<i32>(_e135);
let _e138 = select(_e126, _e136, (_e136 < _e126));
let _e144 = global_6.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e146 = ((2u * _e121) + _e123);
let _e147 = bitcast<i32>(_e146);
let _e149 = select(_e126, _e147, (_e147 < _e126));
let _e155 = global_6.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e157 = ((3u * _e121) + _e123);
let _e158 = bitcast<i32>(_e157);
let _e160 = select(_e126, _e158, (_e158 < _e126));
let _e166 = global_6.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e168 = ((4u * _e121) + _e123);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e126, _e169, (_e169 < _e126));
let _e177 = global_6.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((5u * _e121) + _e123);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e126, _e180, (_e180 < _e126));
let _e188 = global_6.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((6u * _e121) + _e123);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e126, _e191, (_e191 < _e126));
let _e199 = global_6.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((7u * _e121) + _e123);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e126, _e202, (_e202 < _e126));
let _e210 = global_6.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((8u * _e121) + _e123);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e126, _e213, (_e213 < _e126));
let _e221 = global_6.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = ((9u * _e121) + _e123);
let _e224 = bitcast<i32>(_e223);
let _e226 = select(_e126, _e224, (_e224 < _e126));
let _e232 = global_6.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e234 = ((10u * _e121) + _e123);
let _e235 = bitcast<i32>(_e234);
let _e237 = select(_e126, _e235, (_e235 < _e126));
let _e243 = global_6.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e247 = global_1.member.member_4.member_2;
let _e250 = (1f / select(1e-6f, _e199, (_e199 > 1e-6f)));
let _e254 = global_1.member.member_7.member_3;
let _e255 = (_e247 * _e254);
let _e260 = global_1.member.member_8.member;
let _e262 = (((_e177 * _e250) - _e260) * _e255);
let _e267 = global_1.member.member_8.member_1;
let _e269 = (((_e188 * _e250) - _e267) * _e255);
let _e273 = ((f32(bitcast<i32>(_e105)) - 0.5f) + _e134);
let _e277 = global_1.member.member_2[3u];
let _e278 = (_e277 + 1u);
let _e280 = select(1u, _e278, (_e278 > 0u));
let _e281 = (_e280 == 0u);
if _e281 {
break;
}
let _e286 = ((f32(bitcast<i32>((_e108 % _e280))) - 0.5f) + _e144);
let _e290 = global_1.member.member_4.member;
let _e294 = global_1.member.member_8.member_2;
let _e295 = (_e290 - _e294);
let _e299 = global_1.member.member_7.member;
let _e306 = global_1.member.member_7.member_2;
let _e308 = ((_e299 + (_e260 * _e295)) + ((_e273 + 0.5f) * _e306));
let _e312 = global_1.member.member_7.member_1;
let _e317 = ((_e312 + (_e267 * _e295)) + ((_e286 + 0.5f) * _e306));
let _e323 = global_1.member.member_4.member_1;
let _e324 = (_e323 - _e294);
let _e329 = ((_e299 + (_e260 * _e324)) + (((_e273 + _e262) + 0.5f) * _e306));
let _e334 = ((_e312 + (_e267 * _e324)) + (((_e286 + _e269) + 0.5f) * _e306));
if _e281 {
break;
}
let _e337 = bitcast<i32>(((_e108 / _e280) * 3u));
let _e339 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e341 = select(_e339, _e337, (_e337 < _e339));
let _e347 = global_5.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e348 = (_e337 + 1i);
let _e350 = select(_e339, _e348, (_e348 < _e339));
let _e356 = global_5.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
let _e357 = (_e337 + 2i);
let _e359 = select(_e339, _e357, (_e357 < _e339));
let _e365 = global_5.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e368 = (1f / select(1e-6f, _e365, (_e365 > 1e-6f)));
let _e371 = (((_e347 * _e368) - _e260) * _e255);
let _e374 = (((_e356 * _e368) - _e267) * _e255);
let _e386 = global_1.member.member_5.member;
let _e399 = global_1.member.member_5.member.member_3;
let _e400 = ((((_e386.member * _e308) + (_e386.member_1 * _e317)) + (_e386.member_2 * _e290)) + _e399);
let _e404 = global_1.member.member_5.member_1;
let _e417 = global_1.member.member_5.member_1.member_3;
let _e418 = ((((_e404.member * _e308) + (_e404.member_1 * _e317)) + (_e404.member_2 * _e290)) + _e417);
let _e422 = global_1.member.member_5.member_2;
let _e435 = global_1.member.member_5.member_2.member_3;
let _e436 = ((((_e422.member * _e308) + (_e422.member_1 * _e317)) + (_e422.member_2 * _e290)) + _e435);
let _e442 = ((((_e386.member * _e329) + (_e386.member_1 * _e334)) + (_e386.member_2 * _e323)) + _e399);
let _e448 = ((((_e404.member * _e329) + (_e404.member_1 * _e334)) + (_e404.member_2 * _e323)) + _e417);
let _e454 = ((((_e422.member * _e329) + (_e422.member_1 * _e334)) + (_e422.member_2 * _e323)) + _e435);
let _e459 = global_1.member.member_5.member_3.member_3;
let _e464 = global_1.member.member_5.member_3.member;
let _e465 = (_e464 - 0.5f);
let _e467 = select(-0.5f, _e442, (_e442 > -0.5f));
let _e469 = select(_e465, _e467, (_e467 < _e465));
let _e474 = global_1.member.member_5.member_3.member_1;
let _e475 = (_e474 - 0.5f);
let _e477 = select(-0.5f, _e448, (_e448 > -0.5f));
let _e479 = select(_e475, _e477, (_e477 < _e475));
let _e484 = global_1.member.member_5.member_3.member_2;
let _e485 = (_e484 - 0.5f);
let _e487 = select(-0.5f, _e454, (_e454 > -0.5f));
let _e489 = select(_e485, _e487, (_e487 < _e485));
let _e490 = (_e442 - _e400);
let _e491 = (_e448 - _e418);
let _e492 = (_e454 - _e436);
let _e495 = bitcast<f32>((bitcast<u32>(_e490) & 2147483647u));
let _e498 = bitcast<f32>((bitcast<u32>(_e491) & 2147483647u));
let _e500 = select(_e498, _e495, (_e495 > _e498));
let _e503 = bitcast<f32>((bitcast<u32>(_e492) & 2147483647u));
let _e512 = bitcast<f32>((bitcast<u32>((_e442 - _e469)) & 2147483647u));
let _e515 = bitcast<f32>((bitcast<u32>((_e448 - _e479)) & 2147483647u));
let _e517 = select(_e515, _e512, (_e512 > _e515));
let _e520 = bitcast<f32>((bitcast<u32>((_e454 - _e489)) & 2147483647u));
let _e524 = (_e469 + 0.5f);
let _e525 = (_e464 - 1f);
let _e527 = select(0f, _e524, (_e524 > 0f));
let _e529 = select(_e525, _e527, (_e527 < _e525));
let _e536 = select(0i, select(select(i32(_e529), i32(-2147483648), (_e529 < -2147483600f)), 2147483647i, (_e529 > 2147483500f)), (_e529 == _e529));
let _e545 = global_1.member.member_5.member_7[3u];
let _e546 = (_e545 & 31i);
let _e549 = (_e479 + 0.5f);
let _e550 = (_e474 - 1f);
let _e552 = select(0f, _e549, (_e549 > 0f));
let _e554 = select(_e550, _e552, (_e552 < _e550));
let _e561 = select(0i, select(select(i32(_e554), i32(-2147483648), (_e554 < -2147483600f)), 2147483647i, (_e554 > 2147483500f)), (_e554 == _e554));
let _e568 = (_e489 + 0.5f);
let _e569 = (_e484 - 1f);
let _e571 = select(0f, _e568, (_e568 > 0f));
let _e573 = select(_e569, _e571, (_e571 < _e569));
let _e580 = select(0i, select(select(i32(_e573), i32(-2147483648), (_e573 < -2147483600f)), 2147483647i, (_e573 > 2147483500f)), (_e573 == _e573));
let _e591 = global_1.member.member_5.member_6[3u];
let _e597 = global_1.member.member_5.member_6[0u];
let _e602 = global_1.member.member_5.member_6[1u];
let _e606 = ((_e591 + ((_e536 - select(0i, 1i, (_e529 < f32(_e536)))) >> bitcast<u32>(_e546))) + (_e597 * (((_e561 - select(0i, 1i, (_e554 < f32(_e561)))) >> bitcast<u32>(_e546)) + (_e602 * ((_e580 - select(0i, 1i, (_e573 < f32(_e580)))) >> bitcast<u32>(_e546))))));
let _e608 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e610 = select(_e608, _e606, (_e606 < _e608));
let _e616 = global_3.member[bitcast<u32>(select(0i, _e610, (_e610 > 0i)))];
let _e623 = global_1.member.member[3u];
let _e630 = (((_e623 & 64u) != 0u) || ((((select(_e503, _e500, (_e500 > _e503)) <= _e459) && ((select(_e520, _e517, (_e517 > _e520)) > _e459) || (_e616 != 0u))) && true) && ((_e623 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e262 == 0f) && (_e269 == 0f)) && (_e371 == 0f)) && (_e374 == 0f))), _e630), (_e243 == 0f)) > 1u) {
let _e638 = global_1.member.member[2u];
if _e281 {
break;
}
if _e281 {
break;
}
let _e640 = (_e638 == 2u);
let _e643 = (((_e638 == 1u) || _e640) || (_e638 == 5u));
if _e643 {
let _e894 = select(-1f, _e469, (_e469 > -1f));
let _e896 = select(_e464, _e894, (_e894 < _e464));
let _e903 = select(0i, select(select(i32(_e896), i32(-2147483648), (_e896 < -2147483600f)), 2147483647i, (_e896 > 2147483500f)), (_e896 == _e896));
let _e907 = (_e903 - select(0i, 1i, (_e896 < f32(_e903))));
let _e909 = select(-1f, _e479, (_e479 > -1f));
let _e911 = select(_e474, _e909, (_e909 < _e474));
let _e918 = select(0i, select(select(i32(_e911), i32(-2147483648), (_e911 < -2147483600f)), 2147483647i, (_e911 > 2147483500f)), (_e911 == _e911));
let _e922 = (_e918 - select(0i, 1i, (_e911 < f32(_e918))));
let _e924 = select(-1f, _e489, (_e489 > -1f));
let _e926 = select(_e484, _e924, (_e924 < _e484));
let _e933 = select(0i, select(select(i32(_e926), i32(-2147483648), (_e926 < -2147483600f)), 2147483647i, (_e926 > 2147483500f)), (_e926 == _e926));
let _e937 = (_e933 - select(0i, 1i, (_e926 < f32(_e933))));
let _e942 = global_1.member.member_5.member_5[0u];
let _e947 = global_1.member.member_5.member_5[1u];
let _e948 = (_e907 + 1i);
let _e949 = (_e922 + 1i);
let _e950 = (_e937 + 1i);
let _e957 = global_1.member.member_5.member_7[0u];
let _e964 = global_1.member.member_5.member_7[1u];
let _e970 = ((_e948 >> bitcast<u32>(4i)) + (_e957 * ((_e949 >> bitcast<u32>(4i)) + (_e964 * (_e950 >> bitcast<u32>(4i))))));
let _e972 = (bitcast<i32>(_e91) - 1i);
let _e974 = select(_e972, _e970, (_e970 < _e972));
let _e980 = global_2.member[bitcast<u32>(select(0i, _e974, (_e974 > 0i)))];
let _e982 = (_e948 & 15i);
let _e985 = ((_e949 & 15i) * _e942);
let _e987 = (bitcast<i32>(_e980) + ((_e950 & 15i) * _e947));
let _e991 = (_e985 + _e942);
let _e993 = (_e985 + (2i * _e942));
let _e995 = (_e985 + (3i * _e942));
let _e996 = (_e987 + _e947);
let _e998 = (_e987 + (2i * _e947));
let _e1000 = (_e987 + (3i * _e947));
local_4 = type_18(array<i32, 4>(_e982, (_e982 + 1i), (_e982 + 2i), (_e982 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e469 - f32(_e907)), (_e479 - f32(_e922)), (_e489 - f32(_e937)));
let _e1011 = (_e996 + _e991);
let _e1014 = local_4.member[0u];
let _e1015 = (_e1011 + _e1014);
let _e1017 = select(_e972, _e1015, (_e1015 < _e972));
let _e1022 = global_2.member[bitcast<u32>(select(0i, _e1017, (_e1017 > 0i)))];
let _e1023 = bitcast<f32>(_e1022);
let _e1026 = local_4.member[1u];
let _e1027 = (_e1011 + _e1026);
let _e1029 = select(_e972, _e1027, (_e1027 < _e972));
let _e1034 = global_2.member[bitcast<u32>(select(0i, _e1029, (_e1029 > 0i)))];
let _e1035 = bitcast<f32>(_e1034);
let _e1038 = local_4.member[2u];
let _e1039 = (_e1011 + _e1038);
let _e1041 = select(_e972, _e1039, (_e1039 < _e972));
let _e1046 = global_2.member[bitcast<u32>(select(0i, _e1041, (_e1041 > 0i)))];
let _e1047 = bitcast<f32>(_e1046);
let _e1050 = local_4.member[3u];
let _e1051 = (_e1011 + _e1050);
let _e1053 = select(_e972, _e1051, (_e1051 < _e972));
let _e1058 = global_2.member[bitcast<u32>(select(0i, _e1053, (_e1053 > 0i)))];
let _e1060 = local_5[0u];
let _e1063 = (_e1023 + ((_e1035 - _e1023) * _e1060));
let _e1064 = local_5[0u];
let _e1067 = (_e1035 + ((_e1047 - _e1035) * _e1064));
let _e1068 = local_5[0u];
let _e1071 = (_e1047 + ((bitcast<f32>(_e1058) - _e1047) * _e1068));
let _e1072 = (_e996 + _e993);
let _e1073 = local_4.member[0u];
let _e1074 = (_e1072 + _e1073);
let _e1076 = select(_e972, _e1074, (_e1074 < _e972));
let _e1081 = global_2.member[bitcast<u32>(select(0i, _e1076, (_e1076 > 0i)))];
let _e1082 = bitcast<f32>(_e1081);
let _e1083 = local_4.member[1u];
let _e1084 = (_e1072 + _e1083);
let _e1086 = select(_e972, _e1084, (_e1084 < _e972));
let _e1091 = global_2.member[bitcast<u32>(select(0i, _e1086, (_e1086 > 0i)))];
let _e1092 = bitcast<f32>(_e1091);
let _e1093 = local_4.member[2u];
let _e1094 = (_e1072 + _e1093);
let _e1096 = select(_e972, _e1094, (_e1094 < _e972));
let _e1101 = global_2.member[bitcast<u32>(select(0i, _e1096, (_e1096 > 0i)))];
let _e1102 = bitcast<f32>(_e1101);
let _e1103 = local_4.member[3u];
let _e1104 = (_e1072 + _e1103);
let _e1106 = select(_e972, _e1104, (_e1104 < _e972));
let _e1111 = global_2.member[bitcast<u32>(select(0i, _e1106, (_e1106 > 0i)))];
let _e1113 = local_5[0u];
let _e1117 = local_5[0u];
let _e1120 = (_e1092 + ((_e1102 - _e1092) * _e1117));
let _e1121 = local_5[0u];
let _e1125 = (_e998 + _e991);
let _e1126 = local_4.member[0u];
let _e1127 = (_e1125 + _e1126);
let _e1129 = select(_e972, _e1127, (_e1127 < _e972));
let _e1134 = global_2.member[bitcast<u32>(select(0i, _e1129, (_e1129 > 0i)))];
let _e1135 = bitcast<f32>(_e1134);
let _e1136 = local_4.member[1u];
let _e1137 = (_e1125 + _e1136);
let _e1139 = select(_e972, _e1137, (_e1137 < _e972));
let _e1144 = global_2.member[bitcast<u32>(select(0i, _e1139, (_e1139 > 0i)))];
let _e1145 = bitcast<f32>(_e1144);
let _e1146 = local_4.member[2u];
let _e1147 = (_e1125 + _e1146);
let _e1149 = select(_e972, _e1147, (_e1147 < _e972));
let _e1154 = global_2.member[bitcast<u32>(select(0i, _e1149, (_e1149 > 0i)))];
let _e1155 = bitcast<f32>(_e1154);
let _e1156 = local_4.member[3u];
let _e1157 = (_e1125 + _e1156);
let _e1159 = select(_e972, _e1157, (_e1157 < _e972));
let _e1164 = global_2.member[bitcast<u32>(select(0i, _e1159, (_e1159 > 0i)))];
let _e1166 = local_5[0u];
let _e1169 = (_e1135 + ((_e1145 - _e1135) * _e1166));
let _e1170 = local_5[0u];
let _e1173 = (_e1145 + ((_e1155 - _e1145) * _e1170));
let _e1174 = local_5[0u];
let _e1177 = (_e1155 + ((bitcast<f32>(_e1164) - _e1155) * _e1174));
let _e1178 = (_e998 + _e993);
let _e1179 = local_4.member[0u];
let _e1180 = (_e1178 + _e1179);
let _e1182 = select(_e972, _e1180, (_e1180 < _e972));
let _e1187 = global_2.member[bitcast<u32>(select(0i, _e1182, (_e1182 > 0i)))];
let _e1188 = bitcast<f32>(_e1187);
let _e1189 = local_4.member[1u];
let _e1190 = (_e1178 + _e1189);
let _e1192 = select(_e972, _e1190, (_e1190 < _e972));
let _e1197 = global_2.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1198 = bitcast<f32>(_e1197);
let _e1199 = local_4.member[2u];
let _e1200 = (_e1178 + _e1199);
let _e1202 = select(_e972, _e1200, (_e1200 < _e972));
let _e1207 = global_2.member[bitcast<u32>(select(0i, _e1202, (_e1202 > 0i)))];
let _e1208 = bitcast<f32>(_e1207);
let _e1209 = local_4.member[3u];
let _e1210 = (_e1178 + _e1209);
let _e1212 = select(_e972, _e1210, (_e1210 < _e972));
let _e1217 = global_2.member[bitcast<u32>(select(0i, _e1212, (_e1212 > 0i)))];
let _e1219 = local_5[0u];
let _e1223 = local_5[0u];
let _e1226 = (_e1198 + ((_e1208 - _e1198) * _e1223));
let _e1227 = local_5[0u];
let _e1231 = (_e996 + _e985);
let _e1232 = local_4.member[1u];
let _e1233 = (_e1231 + _e1232);
let _e1235 = select(_e972, _e1233, (_e1233 < _e972));
let _e1240 = global_2.member[bitcast<u32>(select(0i, _e1235, (_e1235 > 0i)))];
let _e1241 = bitcast<f32>(_e1240);
let _e1242 = local_4.member[2u];
let _e1243 = (_e1231 + _e1242);
let _e1245 = select(_e972, _e1243, (_e1243 < _e972));
let _e1250 = global_2.member[bitcast<u32>(select(0i, _e1245, (_e1245 > 0i)))];
let _e1252 = local_5[0u];
let _e1255 = (_e1241 + ((bitcast<f32>(_e1250) - _e1241) * _e1252));
let _e1256 = (_e996 + _e995);
let _e1257 = local_4.member[1u];
let _e1258 = (_e1256 + _e1257);
let _e1260 = select(_e972, _e1258, (_e1258 < _e972));
let _e1265 = global_2.member[bitcast<u32>(select(0i, _e1260, (_e1260 > 0i)))];
let _e1266 = bitcast<f32>(_e1265);
let _e1267 = local_4.member[2u];
let _e1268 = (_e1256 + _e1267);
let _e1270 = select(_e972, _e1268, (_e1268 < _e972));
let _e1275 = global_2.member[bitcast<u32>(select(0i, _e1270, (_e1270 > 0i)))];
let _e1277 = local_5[0u];
let _e1281 = (_e998 + _e985);
let _e1282 = local_4.member[1u];
let _e1283 = (_e1281 + _e1282);
let _e1285 = select(_e972, _e1283, (_e1283 < _e972));
let _e1290 = global_2.member[bitcast<u32>(select(0i, _e1285, (_e1285 > 0i)))];
let _e1291 = bitcast<f32>(_e1290);
let _e1292 = local_4.member[2u];
let _e1293 = (_e1281 + _e1292);
let _e1295 = select(_e972, _e1293, (_e1293 < _e972));
let _e1300 = global_2.member[bitcast<u32>(select(0i, _e1295, (_e1295 > 0i)))];
let _e1302 = local_5[0u];
let _e1305 = (_e1291 + ((bitcast<f32>(_e1300) - _e1291) * _e1302));
let _e1306 = (_e998 + _e995);
let _e1307 = local_4.member[1u];
let _e1308 = (_e1306 + _e1307);
let _e1310 = select(_e972, _e1308, (_e1308 < _e972));
let _e1315 = global_2.member[bitcast<u32>(select(0i, _e1310, (_e1310 > 0i)))];
let _e1316 = bitcast<f32>(_e1315);
let _e1317 = local_4.member[2u];
let _e1318 = (_e1306 + _e1317);
let _e1320 = select(_e972, _e1318, (_e1318 < _e972));
let _e1325 = global_2.member[bitcast<u32>(select(0i, _e1320, (_e1320 > 0i)))];
let _e1327 = local_5[0u];
let _e1331 = (_e987 + _e991);
let _e1332 = local_4.member[1u];
let _e1333 = (_e1331 + _e1332);
let _e1335 = select(_e972, _e1333, (_e1333 < _e972));
let _e1340 = global_2.member[bitcast<u32>(select(0i, _e1335, (_e1335 > 0i)))];
let _e1341 = bitcast<f32>(_e1340);
let _e1342 = local_4.member[2u];
let _e1343 = (_e1331 + _e1342);
let _e1345 = select(_e972, _e1343, (_e1343 < _e972));
let _e1350 = global_2.member[bitcast<u32>(select(0i, _e1345, (_e1345 > 0i)))];
let _e1352 = local_5[0u];
let _e1355 = (_e1341 + ((bitcast<f32>(_e1350) - _e1341) * _e1352));
let _e1356 = (_e1000 + _e991);
let _e1357 = local_4.member[1u];
let _e1358 = (_e1356 + _e1357);
let _e1360 = select(_e972, _e1358, (_e1358 < _e972));
let _e1365 = global_2.member[bitcast<u32>(select(0i, _e1360, (_e1360 > 0i)))];
let _e1366 = bitcast<f32>(_e1365);
let _e1367 = local_4.member[2u];
let _e1368 = (_e1356 + _e1367);
let _e1370 = select(_e972, _e1368, (_e1368 < _e972));
let _e1375 = global_2.member[bitcast<u32>(select(0i, _e1370, (_e1370 > 0i)))];
let _e1377 = local_5[0u];
let _e1380 = (_e1366 + ((bitcast<f32>(_e1375) - _e1366) * _e1377));
let _e1381 = (_e987 + _e993);
let _e1382 = local_4.member[1u];
let _e1383 = (_e1381 + _e1382);
let _e1385 = select(_e972, _e1383, (_e1383 < _e972));
let _e1390 = global_2.member[bitcast<u32>(select(0i, _e1385, (_e1385 > 0i)))];
let _e1391 = bitcast<f32>(_e1390);
let _e1392 = local_4.member[2u];
let _e1393 = (_e1381 + _e1392);
let _e1395 = select(_e972, _e1393, (_e1393 < _e972));
let _e1400 = global_2.member[bitcast<u32>(select(0i, _e1395, (_e1395 > 0i)))];
let _e1402 = local_5[0u];
let _e1406 = (_e1000 + _e993);
let _e1407 = local_4.member[1u];
let _e1408 = (_e1406 + _e1407);
let _e1410 = select(_e972, _e1408, (_e1408 < _e972));
let _e1415 = global_2.member[bitcast<u32>(select(0i, _e1410, (_e1410 > 0i)))];
let _e1416 = bitcast<f32>(_e1415);
let _e1417 = local_4.member[2u];
let _e1418 = (_e1406 + _e1417);
let _e1420 = select(_e972, _e1418, (_e1418 < _e972));
let _e1425 = global_2.member[bitcast<u32>(select(0i, _e1420, (_e1420 > 0i)))];
let _e1427 = local_5[0u];
let _e1432 = local_5[1u];
let _e1435 = (_e1067 + ((_e1120 - _e1067) * _e1432));
let _e1436 = local_5[1u];
let _e1439 = (_e1173 + ((_e1226 - _e1173) * _e1436));
let _e1440 = local_5[1u];
let _e1443 = (_e1063 + (((_e1082 + ((_e1092 - _e1082) * _e1113)) - _e1063) * _e1440));
let _e1444 = local_5[1u];
let _e1449 = local_5[2u];
let _e1453 = local_5[1u];
let _e1456 = (_e1071 + (((_e1102 + ((bitcast<f32>(_e1111) - _e1102) * _e1121)) - _e1071) * _e1453));
let _e1457 = local_5[1u];
let _e1461 = local_5[2u];
let _e1465 = local_5[1u];
let _e1468 = (_e1255 + ((_e1067 - _e1255) * _e1465));
let _e1469 = local_5[1u];
let _e1473 = local_5[2u];
let _e1477 = local_5[1u];
let _e1480 = (_e1120 + (((_e1266 + ((bitcast<f32>(_e1275) - _e1266) * _e1277)) - _e1120) * _e1477));
let _e1481 = local_5[1u];
let _e1485 = local_5[2u];
let _e1489 = local_5[1u];
let _e1492 = (_e1355 + (((_e1391 + ((bitcast<f32>(_e1400) - _e1391) * _e1402)) - _e1355) * _e1489));
let _e1493 = local_5[2u];
let _e1497 = local_5[1u];
let _e1501 = local_5[2u];
let _e1505 = local_5[2u];
let _e1513 = global_1.member.member_5.member_4.member;
let _e1519 = global_1.member.member_5.member_4.member_1;
let _e1520 = (((_e1435 + ((_e1439 - _e1435) * _e1505)) * _e1513) + _e1519);
let _e1522 = select(0f, _e1520, (_e1520 > 0f));
let _e1524 = select(1f, _e1522, (_e1522 < 1f));
let _e1526 = (((_e1443 + (((_e1169 + (((_e1188 + ((_e1198 - _e1188) * _e1219)) - _e1169) * _e1444)) - _e1443) * _e1449)) * _e1513) + _e1519);
let _e1528 = select(0f, _e1526, (_e1526 > 0f));
let _e1530 = select(1f, _e1528, (_e1528 < 1f));
let _e1532 = (((_e1456 + (((_e1177 + (((_e1208 + ((bitcast<f32>(_e1217) - _e1208) * _e1227)) - _e1177) * _e1457)) - _e1456) * _e1461)) * _e1513) + _e1519);
let _e1534 = select(0f, _e1532, (_e1532 > 0f));
let _e1536 = select(1f, _e1534, (_e1534 < 1f));
let _e1538 = (((_e1468 + (((_e1305 + ((_e1173 - _e1305) * _e1469)) - _e1468) * _e1473)) * _e1513) + _e1519);
let _e1540 = select(0f, _e1538, (_e1538 > 0f));
let _e1542 = select(1f, _e1540, (_e1540 < 1f));
let _e1544 = (((_e1480 + (((_e1226 + (((_e1316 + ((bitcast<f32>(_e1325) - _e1316) * _e1327)) - _e1226) * _e1481)) - _e1480) * _e1485)) * _e1513) + _e1519);
let _e1546 = select(0f, _e1544, (_e1544 > 0f));
let _e1548 = select(1f, _e1546, (_e1546 < 1f));
let _e1550 = (((_e1492 + ((_e1435 - _e1492) * _e1493)) * _e1513) + _e1519);
let _e1552 = select(0f, _e1550, (_e1550 > 0f));
let _e1554 = select(1f, _e1552, (_e1552 < 1f));
let _e1556 = (((_e1439 + (((_e1380 + (((_e1416 + ((bitcast<f32>(_e1425) - _e1416) * _e1427)) - _e1380) * _e1497)) - _e1439) * _e1501)) * _e1513) + _e1519);
let _e1558 = select(0f, _e1556, (_e1556 > 0f));
let _e1560 = select(1f, _e1558, (_e1558 < 1f));
let _e1561 = (_e1524 * 1024f);
let _e1562 = (1024f - 1f);
let _e1564 = select(0f, _e1561, (_e1561 > 0f));
let _e1566 = select(_e1562, _e1564, (_e1564 < _e1562));
let _e1573 = select(0i, select(select(i32(_e1566), i32(-2147483648), (_e1566 < -2147483600f)), 2147483647i, (_e1566 > 2147483500f)), (_e1566 == _e1566));
let _e1577 = (_e1573 - select(0i, 1i, (_e1566 < f32(_e1573))));
let _e1578 = (262147i + _e1577);
let _e1580 = (bitcast<i32>(_e95) - 1i);
let _e1582 = select(_e1580, _e1578, (_e1578 < _e1580));
let _e1588 = global_4.member[bitcast<u32>(select(0i, _e1582, (_e1582 > 0i)))];
let _e1598 = select(_e1580, 262146i, (262146i < _e1580));
let _e1604 = global_4.member[bitcast<u32>(select(0i, _e1598, (_e1598 > 0i)))];
let _e1605 = bitcast<f32>(_e1604);
let _e1606 = (f32((bitcast<i32>((_e1588 & 4095u)) - 2048i)) * _e1605);
let _e1608 = select(_e1580, 262144i, (262144i < _e1580));
let _e1614 = global_4.member[bitcast<u32>(select(0i, _e1608, (_e1608 > 0i)))];
let _e1615 = bitcast<f32>(_e1614);
let _e1617 = select(_e1580, 262145i, (262145i < _e1580));
let _e1623 = global_4.member[bitcast<u32>(select(0i, _e1617, (_e1617 > 0i)))];
let _e1624 = bitcast<f32>(_e1623);
let _e1630 = ((_e1615 + (f32(bitcast<i32>((_e1588 >> bitcast<u32>(12u)))) * _e1624)) + (_e1606 * (_e1561 - f32(_e1577))));
let _e1631 = (_e1606 * 1024f);
if _e640 {
let _e1896 = ((0.5f * (_e1536 - _e1530)) * _e1631);
let _e1897 = ((0.5f * (_e1548 - _e1542)) * _e1631);
let _e1898 = ((0.5f * (_e1560 - _e1554)) * _e1631);
phi_5835_ = type_19(_e1630, vec3<f32>(_e1896, _e1897, _e1898), vec3<f32>((_e1896 * _e1630), (_e1897 * _e1630), (_e1898 * _e1630)));
} else {
let _e1632 = (_e1530 * 1024f);
let _e1634 = select(0f, _e1632, (_e1632 > 0f));
let _e1636 = select(_e1562, _e1634, (_e1634 < _e1562));
let _e1643 = select(0i, select(select(i32(_e1636), i32(-2147483648), (_e1636 < -2147483600f)), 2147483647i, (_e1636 > 2147483500f)), (_e1636 == _e1636));
let _e1647 = (_e1643 - select(0i, 1i, (_e1636 < f32(_e1643))));
let _e1648 = (262147i + _e1647);
let _e1650 = select(_e1580, _e1648, (_e1648 < _e1580));
let _e1656 = global_4.member[bitcast<u32>(select(0i, _e1650, (_e1650 > 0i)))];
let _e1671 = ((_e1615 + (f32(bitcast<i32>((_e1656 >> bitcast<u32>(12u)))) * _e1624)) + ((f32((bitcast<i32>((_e1656 & 4095u)) - 2048i)) * _e1605) * (_e1632 - f32(_e1647))));
let _e1672 = (_e1536 * 1024f);
let _e1674 = select(0f, _e1672, (_e1672 > 0f));
let _e1676 = select(_e1562, _e1674, (_e1674 < _e1562));
let _e1683 = select(0i, select(select(i32(_e1676), i32(-2147483648), (_e1676 < -2147483600f)), 2147483647i, (_e1676 > 2147483500f)), (_e1676 == _e1676));
let _e1687 = (_e1683 - select(0i, 1i, (_e1676 < f32(_e1683))));
let _e1688 = (262147i + _e1687);
let _e1690 = select(_e1580, _e1688, (_e1688 < _e1580));
let _e1696 = global_4.member[bitcast<u32>(select(0i, _e1690, (_e1690 > 0i)))];
let _e1711 = ((_e1615 + (f32(bitcast<i32>((_e1696 >> bitcast<u32>(12u)))) * _e1624)) + ((f32((bitcast<i32>((_e1696 & 4095u)) - 2048i)) * _e1605) * (_e1672 - f32(_e1687))));
let _e1712 = (_e1542 * 1024f);
let _e1714 = select(0f, _e1712, (_e1712 > 0f));
let _e1716 = select(_e1562, _e1714, (_e1714 < _e1562));
let _e1723 = select(0i, select(select(i32(_e1716), i32(-2147483648), (_e1716 < -2147483600f)), 2147483647i, (_e1716 > 2147483500f)), (_e1716 == _e1716));
let _e1727 = (_e1723 - select(0i, 1i, (_e1716 < f32(_e1723))));
let _e1728 = (262147i + _e1727);
let _e1730 = select(_e1580, _e1728, (_e1728 < _e1580));
let _e1736 = global_4.member[bitcast<u32>(select(0i, _e1730, (_e1730 > 0i)))];
let _e1751 = ((_e1615 + (f32(bitcast<i32>((_e1736 >> bitcast<u32>(12u)))) * _e1624)) + ((f32((bitcast<i32>((_e1736 & 4095u)) - 2048i)) * _e1605) * (_e1712 - f32(_e1727))));
let _e1752 = (_e1548 * 1024f);
let _e1754 = select(0f, _e1752, (_e1752 > 0f));
let _e1756 = select(_e1562, _e1754, (_e1754 < _e1562));
let _e1763 = select(0i, select(select(i32(_e1756), i32(-2147483648), (_e1756 < -2147483600f)), 2147483647i, (_e1756 > 2147483500f)), (_e1756 == _e1756));
let _e1767 = (_e1763 - select(0i, 1i, (_e1756 < f32(_e1763))));
let _e1768 = (262147i + _e1767);
let _e1770 = select(_e1580, _e1768, (_e1768 < _e1580));
let _e1776 = global_4.member[bitcast<u32>(select(0i, _e1770, (_e1770 > 0i)))];
let _e1791 = ((_e1615 + (f32(bitcast<i32>((_e1776 >> bitcast<u32>(12u)))) * _e1624)) + ((f32((bitcast<i32>((_e1776 & 4095u)) - 2048i)) * _e1605) * (_e1752 - f32(_e1767))));
let _e1792 = (_e1554 * 1024f);
let _e1794 = select(0f, _e1792, (_e1792 > 0f));
let _e1796 = select(_e1562, _e1794, (_e1794 < _e1562));
let _e1803 = select(0i, select(select(i32(_e1796), i32(-2147483648), (_e1796 < -2147483600f)), 2147483647i, (_e1796 > 2147483500f)), (_e1796 == _e1796));
let _e1807 = (_e1803 - select(0i, 1i, (_e1796 < f32(_e1803))));
let _e1808 = (262147i + _e1807);
let _e1810 = select(_e1580, _e1808, (_e1808 < _e1580));
let _e1816 = global_4.member[bitcast<u32>(select(0i, _e1810, (_e1810 > 0i)))];
let _e1831 = ((_e1615 + (f32(bitcast<i32>((_e1816 >> bitcast<u32>(12u)))) * _e1624)) + ((f32((bitcast<i32>((_e1816 & 4095u)) - 2048i)) * _e1605) * (_e1792 - f32(_e1807))));
let _e1832 = (_e1560 * 1024f);
let _e1834 = select(0f, _e1832, (_e1832 > 0f));
let _e1836 = select(_e1562, _e1834, (_e1834 < _e1562));
let _e1843 = select(0i, select(select(i32(_e1836), i32(-2147483648), (_e1836 < -2147483600f)), 2147483647i, (_e1836 > 2147483500f)), (_e1836 == _e1836));
let _e1847 = (_e1843 - select(0i, 1i, (_e1836 < f32(_e1843))));
let _e1848 = (262147i + _e1847);
let _e1850 = select(_e1580, _e1848, (_e1848 < _e1580));
let _e1856 = global_4.member[bitcast<u32>(select(0i, _e1850, (_e1850 > 0i)))];
let _e1871 = ((_e1615 + (f32(bitcast<i32>((_e1856 >> bitcast<u32>(12u)))) * _e1624)) + ((f32((bitcast<i32>((_e1856 & 4095u)) - 2048i)) * _e1605) * (_e1832 - f32(_e1847))));
let _e1872 = (_e1711 - _e1671);
let _e1874 = (_e1791 - _e1751);
let _e1876 = (_e1871 - _e1831);
phi_5835_ = type_19(_e1630, vec3<f32>((0.5f * _e1872), (0.5f * _e1874), (0.5f * _e1876)), vec3<f32>((0.25f * (_e1872 * (_e1711 + _e1671))), (0.25f * (_e1874 * (_e1791 + _e1751))), (0.25f * (_e1876 * (_e1871 + _e1831)))));
}
let _e1906 = phi_5835_;
let _e1921 = select(0f, 1f, ((((((_e442 >= -0.5f) && (_e442 <= _e465)) && (_e448 >= -0.5f)) && (_e448 <= _e475)) && (_e454 >= -0.5f)) && (_e454 <= _e485)));
let _e1923 = (0.5f * (_e1536 - _e1530));
let _e1925 = (0.5f * (_e1548 - _e1542));
let _e1927 = (0.5f * (_e1560 - _e1554));
let _e1932 = global_1.member.member_5.member.member;
let _e1938 = global_1.member.member_5.member_1.member;
let _e1945 = global_1.member.member_5.member_2.member;
let _e1952 = global_1.member.member_5.member.member_1;
let _e1958 = global_1.member.member_5.member_1.member_1;
let _e1965 = global_1.member.member_5.member_2.member_1;
let _e1972 = global_1.member.member_5.member.member_2;
let _e1978 = global_1.member.member_5.member_1.member_2;
let _e1985 = global_1.member.member_5.member_2.member_2;
phi_7155_ = type_20(_e1524, vec3<f32>(((((_e1932 * _e1923) + (_e1938 * _e1925)) + (_e1945 * _e1927)) * _e1921), ((((_e1952 * _e1923) + (_e1958 * _e1925)) + (_e1965 * _e1927)) * _e1921), ((((_e1972 * _e1923) + (_e1978 * _e1925)) + (_e1985 * _e1927)) * _e1921)), _e1906.member, vec3<f32>(((((_e1932 * _e1906.member_2.x) + (_e1938 * _e1906.member_2.y)) + (_e1945 * _e1906.member_2.z)) * _e1921), ((((_e1952 * _e1906.member_2.x) + (_e1958 * _e1906.member_2.y)) + (_e1965 * _e1906.member_2.z)) * _e1921), ((((_e1972 * _e1906.member_2.x) + (_e1978 * _e1906.member_2.y)) + (_e1985 * _e1906.member_2.z)) * _e1921)), vec3<f32>(((((_e1932 * _e1906.member_1.x) + (_e1938 * _e1906.member_1.y)) + (_e1945 * _e1906.member_1.z)) * _e1921), ((((_e1952 * _e1906.member_1.x) + (_e1958 * _e1906.member_1.y)) + (_e1965 * _e1906.member_1.z)) * _e1921), ((((_e1972 * _e1906.member_1.x) + (_e1978 * _e1906.member_1.y)) + (_e1985 * _e1906.member_1.z)) * _e1921)));
} else {
let _e645 = select(-1f, _e469, (_e469 > -1f));
let _e647 = select(_e464, _e645, (_e645 < _e464));
let _e654 = select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < -2147483600f)), 2147483647i, (_e647 > 2147483500f)), (_e647 == _e647));
let _e658 = (_e654 - select(0i, 1i, (_e647 < f32(_e654))));
let _e660 = select(-1f, _e479, (_e479 > -1f));
let _e662 = select(_e474, _e660, (_e660 < _e474));
let _e669 = select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < -2147483600f)), 2147483647i, (_e662 > 2147483500f)), (_e662 == _e662));
let _e673 = (_e669 - select(0i, 1i, (_e662 < f32(_e669))));
let _e675 = select(-1f, _e489, (_e489 > -1f));
let _e677 = select(_e484, _e675, (_e675 < _e484));
let _e684 = select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < -2147483600f)), 2147483647i, (_e677 > 2147483500f)), (_e677 == _e677));
let _e688 = (_e684 - select(0i, 1i, (_e677 < f32(_e684))));
let _e693 = global_1.member.member_5.member_5[0u];
let _e698 = global_1.member.member_5.member_5[1u];
let _e699 = (_e658 + 1i);
let _e700 = (_e673 + 1i);
let _e701 = (_e688 + 1i);
let _e708 = global_1.member.member_5.member_7[0u];
let _e715 = global_1.member.member_5.member_7[1u];
let _e721 = ((_e699 >> bitcast<u32>(4i)) + (_e708 * ((_e700 >> bitcast<u32>(4i)) + (_e715 * (_e701 >> bitcast<u32>(4i))))));
let _e723 = (bitcast<i32>(_e91) - 1i);
let _e725 = select(_e723, _e721, (_e721 < _e723));
let _e731 = global_2.member[bitcast<u32>(select(0i, _e725, (_e725 > 0i)))];
let _e733 = (_e699 & 15i);
let _e736 = ((_e700 & 15i) * _e693);
let _e738 = (bitcast<i32>(_e731) + ((_e701 & 15i) * _e698));
let _e742 = (_e736 + _e693);
let _e744 = (_e736 + (2i * _e693));
let _e745 = (_e738 + _e698);
let _e747 = (_e738 + (2i * _e698));
local_2 = type_18(array<i32, 4>(_e733, (_e733 + 1i), (_e733 + 2i), (_e733 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e469 - f32(_e658)), (_e479 - f32(_e673)), (_e489 - f32(_e688)));
let _e758 = (_e745 + _e742);
let _e761 = local_2.member[1u];
let _e762 = (_e758 + _e761);
let _e764 = select(_e723, _e762, (_e762 < _e723));
let _e769 = global_2.member[bitcast<u32>(select(0i, _e764, (_e764 > 0i)))];
let _e770 = bitcast<f32>(_e769);
let _e773 = local_2.member[2u];
let _e774 = (_e758 + _e773);
let _e776 = select(_e723, _e774, (_e774 < _e723));
let _e781 = global_2.member[bitcast<u32>(select(0i, _e776, (_e776 > 0i)))];
let _e783 = local_3[0u];
let _e786 = (_e770 + ((bitcast<f32>(_e781) - _e770) * _e783));
let _e787 = (_e745 + _e744);
let _e788 = local_2.member[1u];
let _e789 = (_e787 + _e788);
let _e791 = select(_e723, _e789, (_e789 < _e723));
let _e796 = global_2.member[bitcast<u32>(select(0i, _e791, (_e791 > 0i)))];
let _e797 = bitcast<f32>(_e796);
let _e798 = local_2.member[2u];
let _e799 = (_e787 + _e798);
let _e801 = select(_e723, _e799, (_e799 < _e723));
let _e806 = global_2.member[bitcast<u32>(select(0i, _e801, (_e801 > 0i)))];
let _e808 = local_3[0u];
let _e813 = local_3[1u];
let _e816 = (_e786 + (((_e797 + ((bitcast<f32>(_e806) - _e797) * _e808)) - _e786) * _e813));
let _e817 = (_e747 + _e742);
let _e818 = local_2.member[1u];
let _e819 = (_e817 + _e818);
let _e821 = select(_e723, _e819, (_e819 < _e723));
let _e826 = global_2.member[bitcast<u32>(select(0i, _e821, (_e821 > 0i)))];
let _e827 = bitcast<f32>(_e826);
let _e828 = local_2.member[2u];
let _e829 = (_e817 + _e828);
let _e831 = select(_e723, _e829, (_e829 < _e723));
let _e836 = global_2.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e838 = local_3[0u];
let _e841 = (_e827 + ((bitcast<f32>(_e836) - _e827) * _e838));
let _e842 = (_e747 + _e744);
let _e843 = local_2.member[1u];
let _e844 = (_e842 + _e843);
let _e846 = select(_e723, _e844, (_e844 < _e723));
let _e851 = global_2.member[bitcast<u32>(select(0i, _e846, (_e846 > 0i)))];
let _e852 = bitcast<f32>(_e851);
let _e853 = local_2.member[2u];
let _e854 = (_e842 + _e853);
let _e856 = select(_e723, _e854, (_e854 < _e723));
let _e861 = global_2.member[bitcast<u32>(select(0i, _e856, (_e856 > 0i)))];
let _e863 = local_3[0u];
let _e867 = local_3[1u];
let _e872 = local_3[2u];
let _e880 = global_1.member.member_5.member_4.member;
let _e886 = global_1.member.member_5.member_4.member_1;
let _e887 = (((_e816 + (((_e841 + (((_e852 + ((bitcast<f32>(_e861) - _e852) * _e863)) - _e841) * _e867)) - _e816) * _e872)) * _e880) + _e886);
let _e889 = select(0f, _e887, (_e887 > 0f));
phi_7155_ = type_20(select(1f, _e889, (_e889 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2038 = phi_7155_;
let _e2040 = select(-0.5f, _e400, (_e400 > -0.5f));
let _e2042 = select(_e465, _e2040, (_e2040 < _e465));
let _e2044 = select(-0.5f, _e418, (_e418 > -0.5f));
let _e2046 = select(_e475, _e2044, (_e2044 < _e475));
let _e2048 = select(-0.5f, _e436, (_e436 > -0.5f));
let _e2050 = select(_e485, _e2048, (_e2048 < _e485));
let _e2052 = select(-1f, _e2042, (_e2042 > -1f));
let _e2054 = select(_e464, _e2052, (_e2052 < _e464));
let _e2061 = select(0i, select(select(i32(_e2054), i32(-2147483648), (_e2054 < -2147483600f)), 2147483647i, (_e2054 > 2147483500f)), (_e2054 == _e2054));
let _e2065 = (_e2061 - select(0i, 1i, (_e2054 < f32(_e2061))));
let _e2067 = select(-1f, _e2046, (_e2046 > -1f));
let _e2069 = select(_e474, _e2067, (_e2067 < _e474));
let _e2076 = select(0i, select(select(i32(_e2069), i32(-2147483648), (_e2069 < -2147483600f)), 2147483647i, (_e2069 > 2147483500f)), (_e2069 == _e2069));
let _e2080 = (_e2076 - select(0i, 1i, (_e2069 < f32(_e2076))));
let _e2082 = select(-1f, _e2050, (_e2050 > -1f));
let _e2084 = select(_e484, _e2082, (_e2082 < _e484));
let _e2091 = select(0i, select(select(i32(_e2084), i32(-2147483648), (_e2084 < -2147483600f)), 2147483647i, (_e2084 > 2147483500f)), (_e2084 == _e2084));
let _e2095 = (_e2091 - select(0i, 1i, (_e2084 < f32(_e2091))));
let _e2100 = global_1.member.member_5.member_5[0u];
let _e2105 = global_1.member.member_5.member_5[1u];
let _e2106 = (_e2065 + 1i);
let _e2107 = (_e2080 + 1i);
let _e2108 = (_e2095 + 1i);
let _e2115 = global_1.member.member_5.member_7[0u];
let _e2122 = global_1.member.member_5.member_7[1u];
let _e2128 = ((_e2106 >> bitcast<u32>(4i)) + (_e2115 * ((_e2107 >> bitcast<u32>(4i)) + (_e2122 * (_e2108 >> bitcast<u32>(4i))))));
let _e2130 = (bitcast<i32>(_e91) - 1i);
let _e2132 = select(_e2130, _e2128, (_e2128 < _e2130));
let _e2138 = global_2.member[bitcast<u32>(select(0i, _e2132, (_e2132 > 0i)))];
let _e2140 = (_e2106 & 15i);
let _e2143 = ((_e2107 & 15i) * _e2100);
let _e2145 = (bitcast<i32>(_e2138) + ((_e2108 & 15i) * _e2105));
let _e2149 = (_e2143 + _e2100);
let _e2151 = (_e2143 + (2i * _e2100));
let _e2152 = (_e2145 + _e2105);
let _e2154 = (_e2145 + (2i * _e2105));
local = type_18(array<i32, 4>(_e2140, (_e2140 + 1i), (_e2140 + 2i), (_e2140 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2042 - f32(_e2065)), (_e2046 - f32(_e2080)), (_e2050 - f32(_e2095)));
let _e2165 = (_e2152 + _e2149);
let _e2168 = local.member[1u];
let _e2169 = (_e2165 + _e2168);
let _e2171 = select(_e2130, _e2169, (_e2169 < _e2130));
let _e2176 = global_2.member[bitcast<u32>(select(0i, _e2171, (_e2171 > 0i)))];
let _e2177 = bitcast<f32>(_e2176);
let _e2180 = local.member[2u];
let _e2181 = (_e2165 + _e2180);
let _e2183 = select(_e2130, _e2181, (_e2181 < _e2130));
let _e2188 = global_2.member[bitcast<u32>(select(0i, _e2183, (_e2183 > 0i)))];
let _e2190 = local_1[0u];
let _e2193 = (_e2177 + ((bitcast<f32>(_e2188) - _e2177) * _e2190));
let _e2194 = (_e2152 + _e2151);
let _e2195 = local.member[1u];
let _e2196 = (_e2194 + _e2195);
let _e2198 = select(_e2130, _e2196, (_e2196 < _e2130));
let _e2203 = global_2.member[bitcast<u32>(select(0i, _e2198, (_e2198 > 0i)))];
let _e2204 = bitcast<f32>(_e2203);
let _e2205 = local.member[2u];
let _e2206 = (_e2194 + _e2205);
let _e2208 = select(_e2130, _e2206, (_e2206 < _e2130));
let _e2213 = global_2.member[bitcast<u32>(select(0i, _e2208, (_e2208 > 0i)))];
let _e2215 = local_1[0u];
let _e2220 = local_1[1u];
let _e2223 = (_e2193 + (((_e2204 + ((bitcast<f32>(_e2213) - _e2204) * _e2215)) - _e2193) * _e2220));
let _e2224 = (_e2154 + _e2149);
let _e2225 = local.member[1u];
let _e2226 = (_e2224 + _e2225);
let _e2228 = select(_e2130, _e2226, (_e2226 < _e2130));
let _e2233 = global_2.member[bitcast<u32>(select(0i, _e2228, (_e2228 > 0i)))];
let _e2234 = bitcast<f32>(_e2233);
let _e2235 = local.member[2u];
let _e2236 = (_e2224 + _e2235);
let _e2238 = select(_e2130, _e2236, (_e2236 < _e2130));
let _e2243 = global_2.member[bitcast<u32>(select(0i, _e2238, (_e2238 > 0i)))];
let _e2245 = local_1[0u];
let _e2248 = (_e2234 + ((bitcast<f32>(_e2243) - _e2234) * _e2245));
let _e2249 = (_e2154 + _e2151);
let _e2250 = local.member[1u];
let _e2251 = (_e2249 + _e2250);
let _e2253 = select(_e2130, _e2251, (_e2251 < _e2130));
let _e2258 = global_2.member[bitcast<u32>(select(0i, _e2253, (_e2253 > 0i)))];
let _e2259 = bitcast<f32>(_e2258);
let _e2260 = local.member[2u];
let _e2261 = (_e2249 + _e2260);
let _e2263 = select(_e2130, _e2261, (_e2261 < _e2130));
let _e2268 = global_2.member[bitcast<u32>(select(0i, _e2263, (_e2263 > 0i)))];
let _e2270 = local_1[0u];
let _e2274 = local_1[1u];
let _e2279 = local_1[2u];
let _e2287 = global_1.member.member_5.member_4.member;
let _e2293 = global_1.member.member_5.member_4.member_1;
let _e2294 = (((_e2223 + (((_e2248 + (((_e2259 + ((bitcast<f32>(_e2268) - _e2259) * _e2270)) - _e2248) * _e2274)) - _e2223) * _e2279)) * _e2287) + _e2293);
let _e2296 = select(0f, _e2294, (_e2294 > 0f));
if ((_e623 & 16u) == 0u) {
phi_8676_ = type_21(1f, 1f, 1f);
} else {
let _e2303 = global_1.member.member_18;
let _e2307 = global_1.member.member_22.member;
let _e2317 = ((((_e2303.member * _e308) + (_e2303.member_1 * _e317)) + (_e2303.member_2 * _e290)) + _e2303.member_3);
let _e2323 = ((((_e2303.member * _e329) + (_e2303.member_1 * _e334)) + (_e2303.member_2 * _e323)) + _e2303.member_3);
let _e2325 = select(_e2323, _e2317, (_e2317 < _e2323));
let _e2327 = select(_e2323, _e2317, (_e2317 > _e2323));
let _e2329 = (_e2327 - _e2325);
let _e2332 = (-(_e2325) / select(1e-30f, _e2329, (_e2329 > 1e-30f)));
let _e2334 = select(0f, _e2332, (_e2332 > 0f));
let _e2340 = select(select(select(1f, _e2334, (_e2334 < 1f)), 1f, (_e2327 <= 0f)), 0f, (_e2325 > 0f));
let _e2342 = (_e2307 > 0.5f);
let _e2351 = global_1.member.member_19;
let _e2355 = global_1.member.member_22.member_1;
let _e2365 = ((((_e2351.member * _e308) + (_e2351.member_1 * _e317)) + (_e2351.member_2 * _e290)) + _e2351.member_3);
let _e2371 = ((((_e2351.member * _e329) + (_e2351.member_1 * _e334)) + (_e2351.member_2 * _e323)) + _e2351.member_3);
let _e2373 = select(_e2371, _e2365, (_e2365 < _e2371));
let _e2375 = select(_e2371, _e2365, (_e2365 > _e2371));
let _e2377 = (_e2375 - _e2373);
let _e2380 = (-(_e2373) / select(1e-30f, _e2377, (_e2377 > 1e-30f)));
let _e2382 = select(0f, _e2380, (_e2380 > 0f));
let _e2388 = select(select(select(1f, _e2382, (_e2382 < 1f)), 1f, (_e2375 <= 0f)), 0f, (_e2373 > 0f));
let _e2390 = (_e2355 > 0.5f);
let _e2399 = global_1.member.member_20;
let _e2403 = global_1.member.member_22.member_2;
let _e2413 = ((((_e2399.member * _e308) + (_e2399.member_1 * _e317)) + (_e2399.member_2 * _e290)) + _e2399.member_3);
let _e2419 = ((((_e2399.member * _e329) + (_e2399.member_1 * _e334)) + (_e2399.member_2 * _e323)) + _e2399.member_3);
let _e2421 = select(_e2419, _e2413, (_e2413 < _e2419));
let _e2423 = select(_e2419, _e2413, (_e2413 > _e2419));
let _e2425 = (_e2423 - _e2421);
let _e2428 = (-(_e2421) / select(1e-30f, _e2425, (_e2425 > 1e-30f)));
let _e2430 = select(0f, _e2428, (_e2428 > 0f));
let _e2436 = select(select(select(1f, _e2430, (_e2430 < 1f)), 1f, (_e2423 <= 0f)), 0f, (_e2421 > 0f));
let _e2438 = (_e2403 > 0.5f);
let _e2447 = global_1.member.member_21;
let _e2451 = global_1.member.member_22.member_3;
let _e2461 = ((((_e2447.member * _e308) + (_e2447.member_1 * _e317)) + (_e2447.member_2 * _e290)) + _e2447.member_3);
let _e2467 = ((((_e2447.member * _e329) + (_e2447.member_1 * _e334)) + (_e2447.member_2 * _e323)) + _e2447.member_3);
let _e2469 = select(_e2467, _e2461, (_e2461 < _e2467));
let _e2471 = select(_e2467, _e2461, (_e2461 > _e2467));
let _e2473 = (_e2471 - _e2469);
let _e2476 = (-(_e2469) / select(1e-30f, _e2473, (_e2473 > 1e-30f)));
let _e2478 = select(0f, _e2476, (_e2476 > 0f));
let _e2484 = select(select(select(1f, _e2478, (_e2478 < 1f)), 1f, (_e2471 <= 0f)), 0f, (_e2469 > 0f));
let _e2486 = (_e2451 > 0.5f);
phi_8676_ = type_21(((((1f * _e2340) * _e2388) * _e2436) * _e2484), ((((1f * select(1f, _e2340, _e2342)) * select(1f, _e2388, _e2390)) * select(1f, _e2436, _e2438)) * select(1f, _e2484, _e2486)), ((((1f * select(1f, 0f, (_e2342 && (_e2323 > 0f)))) * select(1f, 0f, (_e2390 && (_e2371 > 0f)))) * select(1f, 0f, (_e2438 && (_e2419 > 0f)))) * select(1f, 0f, (_e2486 && (_e2467 > 0f)))));
}
let _e2495 = phi_8676_;
let _e2496 = (_e329 - _e308);
let _e2497 = (_e334 - _e317);
let _e2498 = (_e323 - _e290);
let _e2503 = (((_e2496 * _e2496) + (_e2497 * _e2497)) + (_e2498 * _e2498));
let _e2507 = (_e495 < 1e-12f);
let _e2509 = (1f / select(_e490, 1f, _e2507));
let _e2511 = ((-0.5f - _e400) * _e2509);
let _e2513 = ((_e465 - _e400) * _e2509);
let _e2519 = select(_e2513, _e2511, (_e2511 < _e2513));
let _e2521 = select(0f, _e2519, (_e2519 > 0f));
let _e2524 = select(select(1f, _e2521, (_e2521 < 1f)), select(2f, 0f, ((_e400 >= -0.5f) && (_e400 <= _e465))), _e2507);
let _e2526 = select(_e2513, _e2511, (_e2511 > _e2513));
let _e2528 = select(0f, _e2526, (_e2526 > 0f));
let _e2531 = select(select(1f, _e2528, (_e2528 < 1f)), 1f, _e2507);
let _e2532 = (_e498 < 1e-12f);
let _e2534 = (1f / select(_e491, 1f, _e2532));
let _e2536 = ((-0.5f - _e418) * _e2534);
let _e2538 = ((_e475 - _e418) * _e2534);
let _e2544 = select(_e2538, _e2536, (_e2536 < _e2538));
let _e2546 = select(0f, _e2544, (_e2544 > 0f));
let _e2549 = select(select(1f, _e2546, (_e2546 < 1f)), select(2f, 0f, ((_e418 >= -0.5f) && (_e418 <= _e475))), _e2532);
let _e2551 = select(_e2538, _e2536, (_e2536 > _e2538));
let _e2553 = select(0f, _e2551, (_e2551 > 0f));
let _e2556 = select(select(1f, _e2553, (_e2553 < 1f)), 1f, _e2532);
let _e2557 = (_e503 < 1e-12f);
let _e2559 = (1f / select(_e492, 1f, _e2557));
let _e2561 = ((-0.5f - _e436) * _e2559);
let _e2563 = ((_e485 - _e436) * _e2559);
let _e2569 = select(_e2563, _e2561, (_e2561 < _e2563));
let _e2571 = select(0f, _e2569, (_e2569 > 0f));
let _e2574 = select(select(1f, _e2571, (_e2571 < 1f)), select(2f, 0f, ((_e436 >= -0.5f) && (_e436 <= _e485))), _e2557);
let _e2576 = select(_e2563, _e2561, (_e2561 > _e2563));
let _e2578 = select(0f, _e2576, (_e2576 > 0f));
let _e2581 = select(select(1f, _e2578, (_e2578 < 1f)), 1f, _e2557);
let _e2583 = select(_e2556, _e2531, (_e2531 < _e2556));
let _e2587 = select(_e2549, _e2524, (_e2524 > _e2549));
let _e2590 = (select(_e2581, _e2583, (_e2583 < _e2581)) - select(_e2574, _e2587, (_e2587 > _e2574)));
let _e2597 = global_1.member.member_4.member_3;
let _e2598 = ((sqrt(select(0f, _e2503, (_e2503 > 0f))) * select(0f, _e2590, (_e2590 > 0f))) * _e2597);
let _e2600 = (select(1f, _e2296, (_e2296 < 1f)) * 255f);
let _e2601 = (_e2038.member * 255f);
let _e2602 = (255f - 1f);
let _e2604 = select(0f, _e2600, (_e2600 > 0f));
let _e2606 = select(_e2602, _e2604, (_e2604 < _e2602));
let _e2613 = select(0i, select(select(i32(_e2606), i32(-2147483648), (_e2606 < -2147483600f)), 2147483647i, (_e2606 > 2147483500f)), (_e2606 == _e2606));
let _e2617 = (_e2613 - select(0i, 1i, (_e2606 < f32(_e2613))));
let _e2619 = select(0f, _e2601, (_e2601 > 0f));
let _e2621 = select(_e2602, _e2619, (_e2619 < _e2602));
let _e2628 = select(0i, select(select(i32(_e2621), i32(-2147483648), (_e2621 < -2147483600f)), 2147483647i, (_e2621 > 2147483500f)), (_e2621 == _e2621));
let _e2632 = (_e2628 - select(0i, 1i, (_e2621 < f32(_e2628))));
let _e2635 = (((_e2617 * 256i) + _e2632) * 4i);
let _e2637 = (_e2600 - f32(_e2617));
let _e2639 = (_e2601 - f32(_e2632));
let _e2641 = (bitcast<i32>(_e95) - 1i);
let _e2643 = select(_e2641, _e2635, (_e2635 < _e2641));
let _e2649 = global_4.member[bitcast<u32>(select(0i, _e2643, (_e2643 > 0i)))];
let _e2650 = (_e2635 + 4i);
let _e2652 = select(_e2641, _e2650, (_e2650 < _e2641));
let _e2658 = global_4.member[bitcast<u32>(select(0i, _e2652, (_e2652 > 0i)))];
let _e2659 = (_e2635 + 1024i);
let _e2661 = select(_e2641, _e2659, (_e2659 < _e2641));
let _e2667 = global_4.member[bitcast<u32>(select(0i, _e2661, (_e2661 > 0i)))];
let _e2668 = (_e2635 + 1028i);
let _e2670 = select(_e2641, _e2668, (_e2668 < _e2641));
let _e2676 = global_4.member[bitcast<u32>(select(0i, _e2670, (_e2670 > 0i)))];
let _e2681 = (bitcast<f32>(((_e2649 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2689 = (_e2681 + (((bitcast<f32>(((_e2658 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2681) * _e2639));
let _e2694 = (bitcast<f32>(((_e2667 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2718 = (bitcast<f32>((((_e2649 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2726 = (_e2718 + (((bitcast<f32>((((_e2658 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2718) * _e2639));
let _e2731 = (bitcast<f32>((((_e2667 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2743 = (_e2635 + 1i);
let _e2745 = select(_e2641, _e2743, (_e2743 < _e2641));
let _e2751 = global_4.member[bitcast<u32>(select(0i, _e2745, (_e2745 > 0i)))];
let _e2752 = (_e2635 + 5i);
let _e2754 = select(_e2641, _e2752, (_e2752 < _e2641));
let _e2760 = global_4.member[bitcast<u32>(select(0i, _e2754, (_e2754 > 0i)))];
let _e2761 = (_e2635 + 1025i);
let _e2763 = select(_e2641, _e2761, (_e2761 < _e2641));
let _e2769 = global_4.member[bitcast<u32>(select(0i, _e2763, (_e2763 > 0i)))];
let _e2770 = (_e2635 + 1029i);
let _e2772 = select(_e2641, _e2770, (_e2770 < _e2641));
let _e2778 = global_4.member[bitcast<u32>(select(0i, _e2772, (_e2772 > 0i)))];
let _e2783 = (bitcast<f32>(((_e2751 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2791 = (_e2783 + (((bitcast<f32>(((_e2760 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2783) * _e2639));
let _e2796 = (bitcast<f32>(((_e2769 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2820 = (bitcast<f32>((((_e2751 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2828 = (_e2820 + (((bitcast<f32>((((_e2760 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2820) * _e2639));
let _e2833 = (bitcast<f32>((((_e2769 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2848 = (_e2598 * _e2495.member_1);
let _e2850 = -(((_e2726 + (((_e2731 + (((bitcast<f32>((((_e2676 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2731) * _e2639)) - _e2726) * _e2637)) * _e2848));
let _e2852 = select(-87f, _e2850, (_e2850 > -87f));
let _e2854 = select(88f, _e2852, (_e2852 < 88f));
let _e2856 = ((_e2854 * 1.442695f) + 0.5f);
let _e2858 = select(-127f, _e2856, (_e2856 > -127f));
let _e2860 = select(128f, _e2858, (_e2858 < 128f));
let _e2867 = select(0i, select(select(i32(_e2860), i32(-2147483648), (_e2860 < -2147483600f)), 2147483647i, (_e2860 > 2147483500f)), (_e2860 == _e2860));
let _e2871 = (_e2867 - select(0i, 1i, (_e2860 < f32(_e2867))));
let _e2872 = f32(_e2871);
let _e2876 = ((_e2854 - (_e2872 * 0.6933594f)) - (_e2872 * -2.1219444e-4f));
let _e2898 = -(((_e2791 + (((_e2796 + (((bitcast<f32>(((_e2778 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2796) * _e2639)) - _e2791) * _e2637)) * _e2848));
let _e2900 = select(-87f, _e2898, (_e2898 > -87f));
let _e2902 = select(88f, _e2900, (_e2900 < 88f));
let _e2904 = ((_e2902 * 1.442695f) + 0.5f);
let _e2906 = select(-127f, _e2904, (_e2904 > -127f));
let _e2908 = select(128f, _e2906, (_e2906 < 128f));
let _e2915 = select(0i, select(select(i32(_e2908), i32(-2147483648), (_e2908 < -2147483600f)), 2147483647i, (_e2908 > 2147483500f)), (_e2908 == _e2908));
let _e2919 = (_e2915 - select(0i, 1i, (_e2908 < f32(_e2915))));
let _e2920 = f32(_e2919);
let _e2924 = ((_e2902 - (_e2920 * 0.6933594f)) - (_e2920 * -2.1219444e-4f));
let _e2946 = -(((_e2828 + (((_e2833 + (((bitcast<f32>((((_e2778 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2833) * _e2639)) - _e2828) * _e2637)) * _e2848));
let _e2948 = select(-87f, _e2946, (_e2946 > -87f));
let _e2950 = select(88f, _e2948, (_e2948 < 88f));
let _e2952 = ((_e2950 * 1.442695f) + 0.5f);
let _e2954 = select(-127f, _e2952, (_e2952 > -127f));
let _e2956 = select(128f, _e2954, (_e2954 < 128f));
let _e2963 = select(0i, select(select(i32(_e2956), i32(-2147483648), (_e2956 < -2147483600f)), 2147483647i, (_e2956 > 2147483500f)), (_e2956 == _e2956));
let _e2967 = (_e2963 - select(0i, 1i, (_e2956 < f32(_e2963))));
let _e2968 = f32(_e2967);
let _e2972 = ((_e2950 - (_e2968 * 0.6933594f)) - (_e2968 * -2.1219444e-4f));
let _e2994 = -(((_e2689 + (((_e2694 + (((bitcast<f32>(((_e2676 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2694) * _e2639)) - _e2689) * _e2637)) * (_e2598 * _e2495.member)));
let _e2996 = select(-87f, _e2994, (_e2994 > -87f));
let _e2998 = select(88f, _e2996, (_e2996 < 88f));
let _e3000 = ((_e2998 * 1.442695f) + 0.5f);
let _e3002 = select(-127f, _e3000, (_e3000 > -127f));
let _e3004 = select(128f, _e3002, (_e3002 < 128f));
let _e3011 = select(0i, select(select(i32(_e3004), i32(-2147483648), (_e3004 < -2147483600f)), 2147483647i, (_e3004 > 2147483500f)), (_e3004 == _e3004));
let _e3015 = (_e3011 - select(0i, 1i, (_e3004 < f32(_e3011))));
let _e3016 = f32(_e3015);
let _e3020 = ((_e2998 - (_e3016 * 0.6933594f)) - (_e3016 * -2.1219444e-4f));
let _e3040 = ((1f + (_e3020 * (1f + (_e3020 * (0.5f + (_e3020 * (0.16666667f + (_e3020 * (0.041666668f + (_e3020 * (0.008333334f + (_e3020 * (0.001388889f + (_e3020 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3015 + 127i)) << bitcast<u32>(23i))));
if _e643 {
let _e3055 = global_1.member.member_24.member_2;
let _e3058 = (_e2038.member_3.x * _e2495.member_2);
let _e3060 = (_e2038.member_3.y * _e2495.member_2);
let _e3062 = (_e2038.member_3.z * _e2495.member_2);
let _e3063 = (0.5f * (_e247 / _e199));
let _e3067 = (_e177 + (_e3058 * _e3063));
let _e3068 = (_e188 + (_e3060 * _e3063));
let _e3069 = (_e199 + (_e3062 * _e3063));
let _e3071 = (2f * _e247);
let _e3073 = ((_e3069 * _e3069) + (_e3071 * _e3062));
let _e3077 = (_e3069 + sqrt(select(0f, _e3073, (_e3073 > 0f))));
let _e3081 = (0.5f * (_e3071 / select(1e-6f, _e3077, (_e3077 > 1e-6f))));
let _e3085 = (_e3067 + (_e3058 * _e3081));
let _e3086 = (_e3068 + (_e3060 * _e3081));
let _e3087 = (_e3069 + (_e3062 * _e3081));
let _e3091 = (_e3055 * _e3055);
let _e3093 = (_e3087 * _e3087);
let _e3101 = (((_e3069 <= 0f) || (_e3073 <= 0f)) || ((_e3087 <= 0f) || (_e3093 <= (_e3091 * (((_e3085 * _e3085) + (_e3086 * _e3086)) + _e3093)))));
let _e3115 = (_e177 + ((_e2038.member_4.x * _e2495.member_2) * _e247));
let _e3116 = (_e188 + ((_e2038.member_4.y * _e2495.member_2) * _e247));
let _e3117 = (_e199 + ((_e2038.member_4.z * _e2495.member_2) * _e247));
let _e3119 = (_e3117 * _e3117);
let _e3128 = ((_e623 & 1u) != 0u);
phi_9700_ = select(select(select(_e3087, _e3069, _e3101), _e3117, _e3128), _e199, _e630);
phi_9701_ = select(select(select(_e3086, _e3068, _e3101), _e3116, _e3128), _e188, _e630);
phi_9702_ = select(select(select(_e3085, _e3067, _e3101), _e3115, _e3128), _e177, _e630);
phi_9703_ = (select(_e3101, ((_e3117 <= 0f) || (_e3119 <= (_e3091 * (((_e3115 * _e3115) + (_e3116 * _e3116)) + _e3119)))), _e3128) && !(_e630));
} else {
phi_9700_ = _e199;
phi_9701_ = _e188;
phi_9702_ = _e177;
phi_9703_ = false;
}
let _e3139 = phi_9700_;
let _e3141 = phi_9701_;
let _e3143 = phi_9702_;
let _e3145 = phi_9703_;
global_6.member[_e123] = (_e134 + _e262);
global_6.member[_e135] = (_e144 + _e269);
global_6.member[_e146] = (_e155 + _e371);
global_6.member[_e157] = (_e166 + _e374);
global_6.member[_e168] = _e3143;
global_6.member[_e179] = _e3141;
global_6.member[_e190] = _e3139;
global_6.member[_e201] = select((_e210 * (((1f + (_e2876 * (1f + (_e2876 * (0.5f + (_e2876 * (0.16666667f + (_e2876 * (0.041666668f + (_e2876 * (0.008333334f + (_e2876 * (0.001388889f + (_e2876 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2871 + 127i)) << bitcast<u32>(23i)))) * _e3040)), _e210, _e630);
global_6.member[_e212] = select((_e221 * (((1f + (_e2924 * (1f + (_e2924 * (0.5f + (_e2924 * (0.16666667f + (_e2924 * (0.041666668f + (_e2924 * (0.008333334f + (_e2924 * (0.001388889f + (_e2924 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2919 + 127i)) << bitcast<u32>(23i)))) * _e3040)), _e221, _e630);
global_6.member[_e223] = select((_e232 * (((1f + (_e2972 * (1f + (_e2972 * (0.5f + (_e2972 * (0.16666667f + (_e2972 * (0.041666668f + (_e2972 * (0.008333334f + (_e2972 * (0.001388889f + (_e2972 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2967 + 127i)) << bitcast<u32>(23i)))) * _e3040)), _e232, _e630);
global_6.member[_e234] = select(_e243, 1f, _e3145);
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
