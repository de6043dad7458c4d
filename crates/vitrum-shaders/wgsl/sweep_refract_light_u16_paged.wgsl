struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_3 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_4 {
member: u32,
member_1: u32,
}
struct type_6 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_7 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_8 {
member: type_7,
member_1: f32,
}
struct type_10 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: type_7,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_11 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_12 {
member: type_7,
member_1: type_7,
}
struct type_13 {
member: type_4,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_14 {
member: type_7,
member_1: f32,
member_2: f32,
}
struct type_15 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: u32,
member_4: type_4,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_4,
member_18: type_13,
member_19: type_7,
member_20: type_14,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_17 {
member: type_8,
member_1: type_7,
}
struct type_18 {
member: type_17,
member_1: type_17,
}
struct type_19 {
member: type_8,
member_1: u32,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_7,
member_8: type_7,
member_9: type_7,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_21 {
member: type_2,
member_1: u32,
member_2: type_3,
member_3: type_4,
member_4: type_4,
member_5: u32,
member_6: u32,
member_7: type_6,
member_8: type_10,
member_9: type_10,
member_10: type_11,
member_11: type_12,
member_12: type_15,
member_13: type_6,
member_14: type_16,
member_15: type_18,
member_16: type_19,
member_17: type_19,
member_18: type_19,
member_19: type_19,
member_20: type_7,
member_21: f32,
member_22: f32,
member_23: type_20,
}
struct type_22 {
member: type_21,
}
struct type_24 {
member: array<u32>,
}
struct type_26 {
member: array<f32>,
}
struct type_29 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_32 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_33 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_34 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: f32,
member_5: f32,
member_6: vec3<f32>,
}
struct type_35 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_24;
@group(0) @binding(4)
var<storage> global_3: type_24;
@group(0) @binding(6)
var<storage, read_write> global_4: type_26;
@group(0) @binding(3)
var<storage> global_5: type_24;
@group(0) @binding(5)
var<storage> global_6: type_26;
fn function_() {
var local: f32;
var local_1: f32;
var local_2: type_29;
var local_3: vec3<f32>;
var local_4: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var local_8: type_29;
var local_9: vec3<f32>;
var local_10: type_29;
var local_11: vec3<f32>;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var local_17: f32;
var local_18: f32;
var local_19: f32;
var local_20: f32;
var local_21: f32;
var local_22: f32;
var local_23: f32;
var local_24: f32;
var local_25: f32;
var local_26: type_29;
var local_27: vec3<f32>;
var phi_903_: bool;
var phi_1083_: bool;
var phi_1086_: bool;
var phi_1270_: bool;
var phi_1593_: u32;
var phi_7363_: type_32;
var phi_8065_: type_33;
var phi_8954_: type_7;
var phi_12682_: type_35;
var phi_14001_: type_34;
var phi_14014_: vec3<f32>;
var phi_14015_: f32;
var phi_16686_: type_34;
var phi_16838_: vec3<f32>;
var phi_16839_: f32;
let _e158 = global;
let _e161 = arrayLength((&global_2.member));
let _e166 = arrayLength((&global_3.member));
let _e168 = arrayLength((&global_6.member));
let _e173 = global_1.member.member_2;
let _e176 = global_1.member.member;
let _e184 = (_e158.x + _e173.member);
let _e186 = (_e158.y + _e173.member_1);
if (_e184 < _e173.member_2) {
if (_e186 < _e173.member_3) {
let _e189 = (_e176.member * _e176.member_1);
let _e191 = ((_e186 * _e176.member) + _e184);
let _e192 = bitcast<i32>(_e191);
let _e194 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e196 = select(_e194, _e192, (_e192 < _e194));
let _e202 = global_4.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e203 = (_e189 + _e191);
let _e204 = bitcast<i32>(_e203);
let _e206 = select(_e194, _e204, (_e204 < _e194));
let _e212 = global_4.member[bitcast<u32>(select(0i, _e206, (_e206 > 0i)))];
let _e214 = ((2u * _e189) + _e191);
let _e215 = bitcast<i32>(_e214);
let _e217 = select(_e194, _e215, (_e215 < _e194));
let _e223 = global_4.member[bitcast<u32>(select(0i, _e217, (_e217 > 0i)))];
let _e225 = ((3u * _e189) + _e191);
let _e226 = bitcast<i32>(_e225);
let _e228 = select(_e194, _e226, (_e226 < _e194));
let _e234 = global_4.member[bitcast<u32>(select(0i, _e228, (_e228 > 0i)))];
let _e236 = ((4u * _e189) + _e191);
let _e237 = bitcast<i32>(_e236);
let _e239 = select(_e194, _e237, (_e237 < _e194));
let _e245 = global_4.member[bitcast<u32>(select(0i, _e239, (_e239 > 0i)))];
let _e247 = ((5u * _e189) + _e191);
let _e248 = bitcast<i32>(_e247);
let _e250 = select(_e194, _e248, (_e248 < _e194));
let _e256 = global_4.member[bitcast<u32>(select(0i, _e250, (_e250 > 0i)))];
let _e258 = ((6u * _e189) + _e191);
let _e259 = bitcast<i32>(_e258);
let _e261 = select(_e194, _e259, (_e259 < _e194));
let _e267 = global_4.member[bitcast<u32>(select(0i, _e261, (_e261 > 0i)))];
let _e269 = ((7u * _e189) + _e191);
let _e270 = bitcast<i32>(_e269);
let _e272 = select(_e194, _e270, (_e270 < _e194));
let _e278 = global_4.member[bitcast<u32>(select(0i, _e272, (_e272 > 0i)))];
let _e280 = ((8u * _e189) + _e191);
let _e281 = bitcast<i32>(_e280);
let _e283 = select(_e194, _e281, (_e281 < _e194));
let _e289 = global_4.member[bitcast<u32>(select(0i, _e283, (_e283 > 0i)))];
let _e294 = global_1.member.member_10.member;
let _e298 = global_1.member.member_10.member_1;
let _e299 = (_e294 * _e298);
if (_e168 >= (_e299 * 4u)) {
let _e303 = bitcast<i32>((_e186 * _e294));
let _e305 = bitcast<i32>(_e184);
let _e310 = global_6.member[bitcast<u32>((_e303 + _e305))];
let _e316 = global_6.member[bitcast<u32>(((bitcast<i32>(_e299) + _e303) + _e305))];
let _e317 = f32(_e305);
let _e319 = f32(bitcast<i32>(_e186));
let _e325 = global_1.member.member_7.member;
let _e329 = global_1.member.member_10.member_8;
let _e330 = (_e325 - _e329);
let _e334 = global_1.member.member_10.member_2;
let _e338 = global_1.member.member_10.member_6;
let _e345 = global_1.member.member_10.member_4;
let _e347 = ((_e334 + (_e338 * _e330)) + (((_e317 - _e310) + 0.5f) * _e345));
let _e351 = global_1.member.member_10.member_3;
let _e355 = global_1.member.member_10.member_7;
let _e360 = ((_e351 + (_e355 * _e330)) + (((_e319 - _e316) + 0.5f) * _e345));
let _e364 = global_1.member.member_7.member_1;
let _e365 = (_e364 - _e329);
let _e370 = ((_e334 + (_e338 * _e365)) + ((_e317 + 0.5f) * _e345));
let _e375 = ((_e351 + (_e355 * _e365)) + ((_e319 + 0.5f) * _e345));
let _e381 = global_1.member.member_8.member.member;
let _e389 = (((_e381.member * _e381.member) + (_e381.member_1 * _e381.member_1)) + (_e381.member_2 * _e381.member_2));
let _e392 = sqrt(select(0f, _e389, (_e389 > 0f)));
let _e393 = ((1.5f * _e345) * _e392);
let _e397 = (select(1f, _e393, (_e393 < 1f)) + (1f / 64f));
let _e399 = select(_e397, 0.5f, (0.5f > _e397));
let _e403 = global_1.member.member_7.member_2;
let _e406 = (_e403 / select(1e-6f, _e256, (_e256 > 1e-6f)));
let _e410 = (_e370 + (_e234 * _e406));
let _e411 = (_e375 + (_e245 * _e406));
let _e412 = (_e364 + (_e256 * _e406));
let _e416 = global_1.member.member_8.member;
let _e427 = ((((_e416.member.member * _e347) + (_e416.member.member_1 * _e360)) + (_e416.member.member_2 * _e325)) + _e416.member_1);
let _e431 = global_1.member.member_8.member_1;
let _e442 = ((((_e431.member.member * _e347) + (_e431.member.member_1 * _e360)) + (_e431.member.member_2 * _e325)) + _e431.member_1);
let _e446 = global_1.member.member_8.member_2;
let _e457 = ((((_e446.member.member * _e347) + (_e446.member.member_1 * _e360)) + (_e446.member.member_2 * _e325)) + _e446.member_1);
let _e463 = ((((_e416.member.member * _e370) + (_e416.member.member_1 * _e375)) + (_e416.member.member_2 * _e364)) + _e416.member_1);
let _e469 = ((((_e431.member.member * _e370) + (_e431.member.member_1 * _e375)) + (_e431.member.member_2 * _e364)) + _e431.member_1);
let _e475 = ((((_e446.member.member * _e370) + (_e446.member.member_1 * _e375)) + (_e446.member.member_2 * _e364)) + _e446.member_1);
let _e481 = global_1.member.member_8.member_3.member;
let _e482 = (_e481 - 1f);
let _e491 = global_1.member.member_8.member_3.member_1;
let _e492 = (_e491 - 1f);
let _e501 = global_1.member.member_8.member_3.member_2;
let _e502 = (_e501 - 1f);
let _e516 = (((((((_e427 >= 0f) && (_e427 <= _e482)) && (_e442 >= 0f)) && (_e442 <= _e492)) && (_e457 >= 0f)) && (_e457 <= _e502)) && ((((((_e463 >= 0f) && (_e463 <= _e482)) && (_e469 >= 0f)) && (_e469 <= _e492)) && (_e475 >= 0f)) && (_e475 <= _e502)));
let _e525 = ((((_e176.member_2 == 1u) || (_e176.member_2 == 5u)) || (_e176.member_2 == 6u)) || ((_e176.member_2 == 2u) || (_e176.member_2 == 7u)));
if _e525 {
let _e526 = (_e399 - 0.5f);
let _e527 = (_e399 + 0.5f);
let _e529 = (_e481 - _e527);
let _e533 = (_e491 - _e527);
let _e538 = (_e501 - _e527);
let _e541 = ((((_e427 >= _e526) && (_e427 <= _e529)) && ((_e442 >= _e526) && (_e442 <= _e533))) && ((_e457 >= _e526) && (_e457 <= _e538)));
let _e544 = global_1.member.member_1;
let _e546 = ((_e544 & 16u) == 0u);
if _e546 {
phi_903_ = _e541;
} else {
let _e551 = global_1.member.member_16.member;
let _e563 = -((_e399 / _e392));
let _e568 = global_1.member.member_16.member_1;
let _e574 = global_1.member.member_17.member;
let _e590 = global_1.member.member_17.member_1;
let _e597 = global_1.member.member_18.member;
let _e613 = global_1.member.member_18.member_1;
let _e620 = global_1.member.member_19.member;
let _e636 = global_1.member.member_19.member_1;
phi_903_ = (_e541 && (((((((((_e551.member.member * _e347) + (_e551.member.member_1 * _e360)) + (_e551.member.member_2 * _e325)) + _e551.member_1) <= _e563) || (_e568 == 0u)) && ((((((_e574.member.member * _e347) + (_e574.member.member_1 * _e360)) + (_e574.member.member_2 * _e325)) + _e574.member_1) <= _e563) || (_e590 == 0u))) && ((((((_e597.member.member * _e347) + (_e597.member.member_1 * _e360)) + (_e597.member.member_2 * _e325)) + _e597.member_1) <= _e563) || (_e613 == 0u))) && ((((((_e620.member.member * _e347) + (_e620.member.member_1 * _e360)) + (_e620.member.member_2 * _e325)) + _e620.member_1) <= _e563) || (_e636 == 0u))));
}
let _e642 = phi_903_;
let _e646 = (_e370 + (_e370 - _e347));
let _e647 = (_e375 + (_e375 - _e360));
let _e648 = (_e364 + (_e364 - _e325));
let _e654 = ((((_e416.member.member * _e646) + (_e416.member.member_1 * _e647)) + (_e416.member.member_2 * _e648)) + _e416.member_1);
let _e660 = ((((_e431.member.member * _e646) + (_e431.member.member_1 * _e647)) + (_e431.member.member_2 * _e648)) + _e431.member_1);
let _e666 = ((((_e446.member.member * _e646) + (_e446.member.member_1 * _e647)) + (_e446.member.member_2 * _e648)) + _e446.member_1);
let _e677 = ((((_e654 >= _e526) && (_e654 <= _e529)) && ((_e660 >= _e526) && (_e660 <= _e533))) && ((_e666 >= _e526) && (_e666 <= _e538)));
if _e546 {
phi_1083_ = _e677;
} else {
let _e682 = global_1.member.member_16.member;
let _e694 = -((_e399 / _e392));
let _e699 = global_1.member.member_16.member_1;
let _e705 = global_1.member.member_17.member;
let _e721 = global_1.member.member_17.member_1;
let _e728 = global_1.member.member_18.member;
let _e744 = global_1.member.member_18.member_1;
let _e751 = global_1.member.member_19.member;
let _e767 = global_1.member.member_19.member_1;
phi_1083_ = (_e677 && (((((((((_e682.member.member * _e646) + (_e682.member.member_1 * _e647)) + (_e682.member.member_2 * _e648)) + _e682.member_1) <= _e694) || (_e699 == 0u)) && ((((((_e705.member.member * _e646) + (_e705.member.member_1 * _e647)) + (_e705.member.member_2 * _e648)) + _e705.member_1) <= _e694) || (_e721 == 0u))) && ((((((_e728.member.member * _e646) + (_e728.member.member_1 * _e647)) + (_e728.member.member_2 * _e648)) + _e728.member_1) <= _e694) || (_e744 == 0u))) && ((((((_e751.member.member * _e646) + (_e751.member.member_1 * _e647)) + (_e751.member.member_2 * _e648)) + _e751.member_1) <= _e694) || (_e767 == 0u))));
}
let _e773 = phi_1083_;
phi_1086_ = (_e516 && (_e642 && _e773));
} else {
phi_1086_ = _e516;
}
let _e777 = phi_1086_;
let _e784 = ((((_e416.member.member * _e410) + (_e416.member.member_1 * _e411)) + (_e416.member.member_2 * _e412)) + _e416.member_1);
let _e790 = ((((_e431.member.member * _e410) + (_e431.member.member_1 * _e411)) + (_e431.member.member_2 * _e412)) + _e431.member_1);
let _e796 = ((((_e446.member.member * _e410) + (_e446.member.member_1 * _e411)) + (_e446.member.member_2 * _e412)) + _e446.member_1);
let _e797 = (_e399 - 0.5f);
let _e798 = (_e399 + 0.5f);
let _e812 = ((((_e784 >= _e797) && (_e784 <= (_e481 - _e798))) && ((_e790 >= _e797) && (_e790 <= (_e491 - _e798)))) && ((_e796 >= _e797) && (_e796 <= (_e501 - _e798))));
let _e815 = global_1.member.member_1;
if ((_e815 & 16u) == 0u) {
phi_1270_ = _e812;
} else {
let _e822 = global_1.member.member_16.member;
let _e834 = -((_e399 / _e392));
let _e839 = global_1.member.member_16.member_1;
let _e845 = global_1.member.member_17.member;
let _e861 = global_1.member.member_17.member_1;
let _e868 = global_1.member.member_18.member;
let _e884 = global_1.member.member_18.member_1;
let _e891 = global_1.member.member_19.member;
let _e907 = global_1.member.member_19.member_1;
phi_1270_ = (_e812 && (((((((((_e822.member.member * _e410) + (_e822.member.member_1 * _e411)) + (_e822.member.member_2 * _e412)) + _e822.member_1) <= _e834) || (_e839 == 0u)) && ((((((_e845.member.member * _e410) + (_e845.member.member_1 * _e411)) + (_e845.member.member_2 * _e412)) + _e845.member_1) <= _e834) || (_e861 == 0u))) && ((((((_e868.member.member * _e410) + (_e868.member.member_1 * _e411)) + (_e868.member.member_2 * _e412)) + _e868.member_1) <= _e834) || (_e884 == 0u))) && ((((((_e891.member.member * _e410) + (_e891.member.member_1 * _e411)) + (_e891.member.member_2 * _e412)) + _e891.member_1) <= _e834) || (_e907 == 0u))));
}
let _e913 = phi_1270_;
let _e920 = global_1.member.member_8.member_4;
let _e921 = (_e481 - 0.5f);
let _e923 = select(-0.5f, _e463, (_e463 > -0.5f));
let _e925 = select(_e921, _e923, (_e923 < _e921));
let _e926 = (_e491 - 0.5f);
let _e928 = select(-0.5f, _e469, (_e469 > -0.5f));
let _e930 = select(_e926, _e928, (_e928 < _e926));
let _e931 = (_e501 - 0.5f);
let _e933 = select(-0.5f, _e475, (_e475 > -0.5f));
let _e935 = select(_e931, _e933, (_e933 < _e931));
let _e941 = bitcast<f32>((bitcast<u32>((_e463 - _e427)) & 2147483647u));
let _e944 = bitcast<f32>((bitcast<u32>((_e469 - _e442)) & 2147483647u));
let _e946 = select(_e944, _e941, (_e941 > _e944));
let _e949 = bitcast<f32>((bitcast<u32>((_e475 - _e457)) & 2147483647u));
let _e958 = bitcast<f32>((bitcast<u32>((_e463 - _e925)) & 2147483647u));
let _e961 = bitcast<f32>((bitcast<u32>((_e469 - _e930)) & 2147483647u));
let _e963 = select(_e961, _e958, (_e958 > _e961));
let _e966 = bitcast<f32>((bitcast<u32>((_e475 - _e935)) & 2147483647u));
let _e970 = (_e925 + 0.5f);
let _e972 = select(0f, _e970, (_e970 > 0f));
let _e974 = select(_e482, _e972, (_e972 < _e482));
let _e981 = select(0i, select(select(i32(_e974), i32(-2147483648), (_e974 < -2147483600f)), 2147483647i, (_e974 > 2147483500f)), (_e974 == _e974));
let _e989 = global_1.member.member_8.member_12;
let _e990 = (_e989 & 31u);
let _e993 = (_e930 + 0.5f);
let _e995 = select(0f, _e993, (_e993 > 0f));
let _e997 = select(_e492, _e995, (_e995 < _e492));
let _e1004 = select(0i, select(select(i32(_e997), i32(-2147483648), (_e997 < -2147483600f)), 2147483647i, (_e997 > 2147483500f)), (_e997 == _e997));
let _e1011 = (_e935 + 0.5f);
let _e1013 = select(0f, _e1011, (_e1011 > 0f));
let _e1015 = select(_e502, _e1013, (_e1013 < _e502));
let _e1022 = select(0i, select(select(i32(_e1015), i32(-2147483648), (_e1015 < -2147483600f)), 2147483647i, (_e1015 > 2147483500f)), (_e1015 == _e1015));
let _e1033 = global_1.member.member_8.member_9.member;
let _e1039 = global_1.member.member_8.member_9.member_1;
let _e1044 = global_1.member.member_8.member_10;
let _e1050 = ((bitcast<i32>(_e1044) + ((_e981 - select(0i, 1i, (_e974 < f32(_e981)))) >> bitcast<u32>(_e990))) + (bitcast<i32>(_e1033) * (((_e1004 - select(0i, 1i, (_e997 < f32(_e1004)))) >> bitcast<u32>(_e990)) + (bitcast<i32>(_e1039) * ((_e1022 - select(0i, 1i, (_e1015 < f32(_e1022)))) >> bitcast<u32>(_e990))))));
let _e1052 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1054 = select(_e1052, _e1050, (_e1050 < _e1052));
let _e1060 = global_5.member[bitcast<u32>(select(0i, _e1054, (_e1054 > 0i)))];
phi_1593_ = select(select(7u, 3u, (_e777 && (!(_e525) || _e913))), 1u, (((_e815 & 64u) != 0u) || ((((select(_e949, _e946, (_e946 > _e949)) <= _e920) && ((select(_e966, _e963, (_e963 > _e966)) > _e920) || (_e1060 != 0u))) && true) && ((_e815 & 32u) != 0u))));
} else {
phi_1593_ = 7u;
}
let _e1073 = phi_1593_;
if (_e1073 > 1u) {
let _e1078 = bitcast<i32>(((_e186 * _e294) + _e184));
let _e1081 = (bitcast<i32>(_e168) - 1i);
let _e1083 = select(_e1081, _e1078, (_e1078 < _e1081));
let _e1089 = global_6.member[bitcast<u32>(select(0i, _e1083, (_e1083 > 0i)))];
let _e1090 = (bitcast<i32>(_e299) + _e1078);
let _e1092 = select(_e1081, _e1090, (_e1090 < _e1081));
let _e1098 = global_6.member[bitcast<u32>(select(0i, _e1092, (_e1092 > 0i)))];
let _e1100 = f32(bitcast<i32>(_e184));
let _e1102 = f32(bitcast<i32>(_e186));
let _e1108 = global_1.member.member_7.member;
let _e1112 = global_1.member.member_10.member_8;
let _e1113 = (_e1108 - _e1112);
let _e1117 = global_1.member.member_10.member_2;
let _e1121 = global_1.member.member_10.member_6;
let _e1128 = global_1.member.member_10.member_4;
let _e1130 = ((_e1117 + (_e1121 * _e1113)) + (((_e1100 - _e1089) + 0.5f) * _e1128));
let _e1134 = global_1.member.member_10.member_3;
let _e1138 = global_1.member.member_10.member_7;
let _e1143 = ((_e1134 + (_e1138 * _e1113)) + (((_e1102 - _e1098) + 0.5f) * _e1128));
let _e1147 = global_1.member.member_7.member_1;
let _e1148 = (_e1147 - _e1112);
let _e1153 = ((_e1117 + (_e1121 * _e1148)) + ((_e1100 + 0.5f) * _e1128));
let _e1158 = ((_e1134 + (_e1138 * _e1148)) + ((_e1102 + 0.5f) * _e1128));
let _e1162 = global_1.member.member_8.member;
let _e1173 = ((((_e1162.member.member * _e1130) + (_e1162.member.member_1 * _e1143)) + (_e1162.member.member_2 * _e1108)) + _e1162.member_1);
let _e1177 = global_1.member.member_8.member_1;
let _e1188 = ((((_e1177.member.member * _e1130) + (_e1177.member.member_1 * _e1143)) + (_e1177.member.member_2 * _e1108)) + _e1177.member_1);
let _e1192 = global_1.member.member_8.member_2;
let _e1203 = ((((_e1192.member.member * _e1130) + (_e1192.member.member_1 * _e1143)) + (_e1192.member.member_2 * _e1108)) + _e1192.member_1);
let _e1209 = ((((_e1162.member.member * _e1153) + (_e1162.member.member_1 * _e1158)) + (_e1162.member.member_2 * _e1147)) + _e1162.member_1);
let _e1215 = ((((_e1177.member.member * _e1153) + (_e1177.member.member_1 * _e1158)) + (_e1177.member.member_2 * _e1147)) + _e1177.member_1);
let _e1221 = ((((_e1192.member.member * _e1153) + (_e1192.member.member_1 * _e1158)) + (_e1192.member.member_2 * _e1147)) + _e1192.member_1);
let _e1223 = (_e176.member_2 == 5u);
let _e1229 = ((_e176.member_2 == 2u) || (_e176.member_2 == 7u));
let _e1230 = ((((_e176.member_2 == 1u) || _e1223) || (_e176.member_2 == 6u)) || _e1229);
if _e1230 {
let _e1235 = global_1.member.member_8.member_3.member;
let _e1236 = (_e1235 - 0.5f);
let _e1238 = select(-0.5f, _e1209, (_e1209 > -0.5f));
let _e1240 = select(_e1236, _e1238, (_e1238 < _e1236));
let _e1245 = global_1.member.member_8.member_3.member_1;
let _e1246 = (_e1245 - 0.5f);
let _e1248 = select(-0.5f, _e1215, (_e1215 > -0.5f));
let _e1250 = select(_e1246, _e1248, (_e1248 < _e1246));
let _e1255 = global_1.member.member_8.member_3.member_2;
let _e1256 = (_e1255 - 0.5f);
let _e1258 = select(-0.5f, _e1221, (_e1221 > -0.5f));
let _e1260 = select(_e1256, _e1258, (_e1258 < _e1256));
let _e1262 = select(-1f, _e1240, (_e1240 > -1f));
let _e1264 = select(_e1235, _e1262, (_e1262 < _e1235));
let _e1271 = select(0i, select(select(i32(_e1264), i32(-2147483648), (_e1264 < -2147483600f)), 2147483647i, (_e1264 > 2147483500f)), (_e1264 == _e1264));
let _e1275 = (_e1271 - select(0i, 1i, (_e1264 < f32(_e1271))));
let _e1277 = select(-1f, _e1250, (_e1250 > -1f));
let _e1279 = select(_e1245, _e1277, (_e1277 < _e1245));
let _e1286 = select(0i, select(select(i32(_e1279), i32(-2147483648), (_e1279 < -2147483600f)), 2147483647i, (_e1279 > 2147483500f)), (_e1279 == _e1279));
let _e1290 = (_e1286 - select(0i, 1i, (_e1279 < f32(_e1286))));
let _e1292 = select(-1f, _e1260, (_e1260 > -1f));
let _e1294 = select(_e1255, _e1292, (_e1292 < _e1255));
let _e1301 = select(0i, select(select(i32(_e1294), i32(-2147483648), (_e1294 < -2147483600f)), 2147483647i, (_e1294 > 2147483500f)), (_e1294 == _e1294));
let _e1305 = (_e1301 - select(0i, 1i, (_e1294 < f32(_e1301))));
let _e1309 = global_1.member.member_8.member_7;
let _e1313 = global_1.member.member_8.member_8;
let _e1314 = (_e1275 + 1i);
let _e1315 = (_e1290 + 1i);
let _e1316 = (_e1305 + 1i);
let _e1321 = global_1.member.member_8.member_11.member;
let _e1327 = global_1.member.member_8.member_11.member_1;
let _e1338 = ((_e1314 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1321) * ((_e1315 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1327) * (_e1316 >> bitcast<u32>(4i))))));
let _e1340 = (bitcast<i32>(_e161) - 1i);
let _e1342 = select(_e1340, _e1338, (_e1338 < _e1340));
let _e1348 = global_2.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1350 = (_e1314 & 15i);
let _e1353 = ((_e1315 & 15i) * _e1309);
let _e1355 = (bitcast<i32>(_e1348) + ((_e1316 & 15i) * _e1313));
let _e1359 = (_e1353 + _e1309);
let _e1361 = (_e1353 + (2i * _e1309));
let _e1363 = (_e1353 + (3i * _e1309));
let _e1364 = (_e1355 + _e1313);
let _e1366 = (_e1355 + (2i * _e1313));
let _e1368 = (_e1355 + (3i * _e1313));
local_26 = type_29(array<i32, 4>(_e1350, (_e1350 + 1i), (_e1350 + 2i), (_e1350 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_27 = vec3<f32>((_e1240 - f32(_e1275)), (_e1250 - f32(_e1290)), (_e1260 - f32(_e1305)));
let _e1379 = (_e1364 + _e1359);
let _e1382 = local_26.member[0u];
let _e1383 = (_e1379 + _e1382);
let _e1385 = (_e1383 >> bitcast<u32>(1i));
let _e1388 = bitcast<u32>(((_e1383 & 1i) * 16i));
let _e1390 = select(_e1340, _e1385, (_e1385 < _e1340));
let _e1395 = global_2.member[bitcast<u32>(select(0i, _e1390, (_e1390 > 0i)))];
let _e1399 = (_e1385 + 1i);
let _e1401 = select(_e1340, _e1399, (_e1399 < _e1340));
let _e1406 = global_2.member[bitcast<u32>(select(0i, _e1401, (_e1401 > 0i)))];
let _e1413 = ((_e1395 >> bitcast<u32>((_e1388 & 31u))) | ((_e1406 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1388) & 31u))));
let _e1416 = local_26.member[2u];
let _e1417 = (_e1379 + _e1416);
let _e1419 = (_e1417 >> bitcast<u32>(1i));
let _e1422 = bitcast<u32>(((_e1417 & 1i) * 16i));
let _e1424 = select(_e1340, _e1419, (_e1419 < _e1340));
let _e1429 = global_2.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1433 = (_e1419 + 1i);
let _e1435 = select(_e1340, _e1433, (_e1433 < _e1340));
let _e1440 = global_2.member[bitcast<u32>(select(0i, _e1435, (_e1435 > 0i)))];
let _e1447 = ((_e1429 >> bitcast<u32>((_e1422 & 31u))) | ((_e1440 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1422) & 31u))));
let _e1450 = local_26.member_1[0u];
let _e1456 = f32(bitcast<i32>(((_e1413 >> bitcast<u32>((_e1450 & 31u))) & 65535u)));
let _e1459 = local_26.member_1[1u];
let _e1465 = f32(bitcast<i32>(((_e1413 >> bitcast<u32>((_e1459 & 31u))) & 65535u)));
let _e1468 = local_26.member_1[4u];
let _e1474 = f32(bitcast<i32>(((_e1447 >> bitcast<u32>((_e1468 & 31u))) & 65535u)));
let _e1477 = local_26.member_1[5u];
let _e1484 = local_27[0u];
let _e1487 = (_e1456 + ((_e1465 - _e1456) * _e1484));
let _e1488 = local_27[0u];
let _e1491 = (_e1465 + ((_e1474 - _e1465) * _e1488));
let _e1492 = local_27[0u];
let _e1495 = (_e1474 + ((f32(bitcast<i32>(((_e1447 >> bitcast<u32>((_e1477 & 31u))) & 65535u))) - _e1474) * _e1492));
let _e1496 = (_e1364 + _e1361);
let _e1497 = local_26.member[0u];
let _e1498 = (_e1496 + _e1497);
let _e1500 = (_e1498 >> bitcast<u32>(1i));
let _e1503 = bitcast<u32>(((_e1498 & 1i) * 16i));
let _e1505 = select(_e1340, _e1500, (_e1500 < _e1340));
let _e1510 = global_2.member[bitcast<u32>(select(0i, _e1505, (_e1505 > 0i)))];
let _e1514 = (_e1500 + 1i);
let _e1516 = select(_e1340, _e1514, (_e1514 < _e1340));
let _e1521 = global_2.member[bitcast<u32>(select(0i, _e1516, (_e1516 > 0i)))];
let _e1528 = ((_e1510 >> bitcast<u32>((_e1503 & 31u))) | ((_e1521 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1503) & 31u))));
let _e1529 = local_26.member[2u];
let _e1530 = (_e1496 + _e1529);
let _e1532 = (_e1530 >> bitcast<u32>(1i));
let _e1535 = bitcast<u32>(((_e1530 & 1i) * 16i));
let _e1537 = select(_e1340, _e1532, (_e1532 < _e1340));
let _e1542 = global_2.member[bitcast<u32>(select(0i, _e1537, (_e1537 > 0i)))];
let _e1546 = (_e1532 + 1i);
let _e1548 = select(_e1340, _e1546, (_e1546 < _e1340));
let _e1553 = global_2.member[bitcast<u32>(select(0i, _e1548, (_e1548 > 0i)))];
let _e1560 = ((_e1542 >> bitcast<u32>((_e1535 & 31u))) | ((_e1553 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1535) & 31u))));
let _e1561 = local_26.member_1[0u];
let _e1567 = f32(bitcast<i32>(((_e1528 >> bitcast<u32>((_e1561 & 31u))) & 65535u)));
let _e1568 = local_26.member_1[1u];
let _e1574 = f32(bitcast<i32>(((_e1528 >> bitcast<u32>((_e1568 & 31u))) & 65535u)));
let _e1575 = local_26.member_1[4u];
let _e1581 = f32(bitcast<i32>(((_e1560 >> bitcast<u32>((_e1575 & 31u))) & 65535u)));
let _e1582 = local_26.member_1[5u];
let _e1589 = local_27[0u];
let _e1593 = local_27[0u];
let _e1596 = (_e1574 + ((_e1581 - _e1574) * _e1593));
let _e1597 = local_27[0u];
let _e1601 = (_e1366 + _e1359);
let _e1602 = local_26.member[0u];
let _e1603 = (_e1601 + _e1602);
let _e1605 = (_e1603 >> bitcast<u32>(1i));
let _e1608 = bitcast<u32>(((_e1603 & 1i) * 16i));
let _e1610 = select(_e1340, _e1605, (_e1605 < _e1340));
let _e1615 = global_2.member[bitcast<u32>(select(0i, _e1610, (_e1610 > 0i)))];
let _e1619 = (_e1605 + 1i);
let _e1621 = select(_e1340, _e1619, (_e1619 < _e1340));
let _e1626 = global_2.member[bitcast<u32>(select(0i, _e1621, (_e1621 > 0i)))];
let _e1633 = ((_e1615 >> bitcast<u32>((_e1608 & 31u))) | ((_e1626 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1608) & 31u))));
let _e1634 = local_26.member[2u];
let _e1635 = (_e1601 + _e1634);
let _e1637 = (_e1635 >> bitcast<u32>(1i));
let _e1640 = bitcast<u32>(((_e1635 & 1i) * 16i));
let _e1642 = select(_e1340, _e1637, (_e1637 < _e1340));
let _e1647 = global_2.member[bitcast<u32>(select(0i, _e1642, (_e1642 > 0i)))];
let _e1651 = (_e1637 + 1i);
let _e1653 = select(_e1340, _e1651, (_e1651 < _e1340));
let _e1658 = global_2.member[bitcast<u32>(select(0i, _e1653, (_e1653 > 0i)))];
let _e1665 = ((_e1647 >> bitcast<u32>((_e1640 & 31u))) | ((_e1658 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1640) & 31u))));
let _e1666 = local_26.member_1[0u];
let _e1672 = f32(bitcast<i32>(((_e1633 >> bitcast<u32>((_e1666 & 31u))) & 65535u)));
let _e1673 = local_26.member_1[1u];
let _e1679 = f32(bitcast<i32>(((_e1633 >> bitcast<u32>((_e1673 & 31u))) & 65535u)));
let _e1680 = local_26.member_1[4u];
let _e1686 = f32(bitcast<i32>(((_e1665 >> bitcast<u32>((_e1680 & 31u))) & 65535u)));
let _e1687 = local_26.member_1[5u];
let _e1694 = local_27[0u];
let _e1697 = (_e1672 + ((_e1679 - _e1672) * _e1694));
let _e1698 = local_27[0u];
let _e1701 = (_e1679 + ((_e1686 - _e1679) * _e1698));
let _e1702 = local_27[0u];
let _e1705 = (_e1686 + ((f32(bitcast<i32>(((_e1665 >> bitcast<u32>((_e1687 & 31u))) & 65535u))) - _e1686) * _e1702));
let _e1706 = (_e1366 + _e1361);
let _e1707 = local_26.member[0u];
let _e1708 = (_e1706 + _e1707);
let _e1710 = (_e1708 >> bitcast<u32>(1i));
let _e1713 = bitcast<u32>(((_e1708 & 1i) * 16i));
let _e1715 = select(_e1340, _e1710, (_e1710 < _e1340));
let _e1720 = global_2.member[bitcast<u32>(select(0i, _e1715, (_e1715 > 0i)))];
let _e1724 = (_e1710 + 1i);
let _e1726 = select(_e1340, _e1724, (_e1724 < _e1340));
let _e1731 = global_2.member[bitcast<u32>(select(0i, _e1726, (_e1726 > 0i)))];
let _e1738 = ((_e1720 >> bitcast<u32>((_e1713 & 31u))) | ((_e1731 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1713) & 31u))));
let _e1739 = local_26.member[2u];
let _e1740 = (_e1706 + _e1739);
let _e1742 = (_e1740 >> bitcast<u32>(1i));
let _e1745 = bitcast<u32>(((_e1740 & 1i) * 16i));
let _e1747 = select(_e1340, _e1742, (_e1742 < _e1340));
let _e1752 = global_2.member[bitcast<u32>(select(0i, _e1747, (_e1747 > 0i)))];
let _e1756 = (_e1742 + 1i);
let _e1758 = select(_e1340, _e1756, (_e1756 < _e1340));
let _e1763 = global_2.member[bitcast<u32>(select(0i, _e1758, (_e1758 > 0i)))];
let _e1770 = ((_e1752 >> bitcast<u32>((_e1745 & 31u))) | ((_e1763 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1745) & 31u))));
let _e1771 = local_26.member_1[0u];
let _e1777 = f32(bitcast<i32>(((_e1738 >> bitcast<u32>((_e1771 & 31u))) & 65535u)));
let _e1778 = local_26.member_1[1u];
let _e1784 = f32(bitcast<i32>(((_e1738 >> bitcast<u32>((_e1778 & 31u))) & 65535u)));
let _e1785 = local_26.member_1[4u];
let _e1791 = f32(bitcast<i32>(((_e1770 >> bitcast<u32>((_e1785 & 31u))) & 65535u)));
let _e1792 = local_26.member_1[5u];
let _e1799 = local_27[0u];
let _e1803 = local_27[0u];
let _e1806 = (_e1784 + ((_e1791 - _e1784) * _e1803));
let _e1807 = local_27[0u];
let _e1814 = local_26.member[1u];
let _e1815 = ((_e1364 + _e1353) + _e1814);
let _e1817 = (_e1815 >> bitcast<u32>(1i));
let _e1820 = bitcast<u32>(((_e1815 & 1i) * 16i));
let _e1822 = select(_e1340, _e1817, (_e1817 < _e1340));
let _e1827 = global_2.member[bitcast<u32>(select(0i, _e1822, (_e1822 > 0i)))];
let _e1831 = (_e1817 + 1i);
let _e1833 = select(_e1340, _e1831, (_e1831 < _e1340));
let _e1838 = global_2.member[bitcast<u32>(select(0i, _e1833, (_e1833 > 0i)))];
let _e1845 = ((_e1827 >> bitcast<u32>((_e1820 & 31u))) | ((_e1838 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1820) & 31u))));
let _e1848 = local_26.member_1[2u];
let _e1854 = f32(bitcast<i32>(((_e1845 >> bitcast<u32>((_e1848 & 31u))) & 65535u)));
let _e1857 = local_26.member_1[3u];
let _e1864 = local_27[0u];
let _e1867 = (_e1854 + ((f32(bitcast<i32>(((_e1845 >> bitcast<u32>((_e1857 & 31u))) & 65535u))) - _e1854) * _e1864));
let _e1869 = local_26.member[1u];
let _e1870 = ((_e1364 + _e1363) + _e1869);
let _e1872 = (_e1870 >> bitcast<u32>(1i));
let _e1875 = bitcast<u32>(((_e1870 & 1i) * 16i));
let _e1877 = select(_e1340, _e1872, (_e1872 < _e1340));
let _e1882 = global_2.member[bitcast<u32>(select(0i, _e1877, (_e1877 > 0i)))];
let _e1886 = (_e1872 + 1i);
let _e1888 = select(_e1340, _e1886, (_e1886 < _e1340));
let _e1893 = global_2.member[bitcast<u32>(select(0i, _e1888, (_e1888 > 0i)))];
let _e1900 = ((_e1882 >> bitcast<u32>((_e1875 & 31u))) | ((_e1893 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1875) & 31u))));
let _e1901 = local_26.member_1[2u];
let _e1907 = f32(bitcast<i32>(((_e1900 >> bitcast<u32>((_e1901 & 31u))) & 65535u)));
let _e1908 = local_26.member_1[3u];
let _e1915 = local_27[0u];
let _e1920 = local_26.member[1u];
let _e1921 = ((_e1366 + _e1353) + _e1920);
let _e1923 = (_e1921 >> bitcast<u32>(1i));
let _e1926 = bitcast<u32>(((_e1921 & 1i) * 16i));
let _e1928 = select(_e1340, _e1923, (_e1923 < _e1340));
let _e1933 = global_2.member[bitcast<u32>(select(0i, _e1928, (_e1928 > 0i)))];
let _e1937 = (_e1923 + 1i);
let _e1939 = select(_e1340, _e1937, (_e1937 < _e1340));
let _e1944 = global_2.member[bitcast<u32>(select(0i, _e1939, (_e1939 > 0i)))];
let _e1951 = ((_e1933 >> bitcast<u32>((_e1926 & 31u))) | ((_e1944 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1926) & 31u))));
let _e1952 = local_26.member_1[2u];
let _e1958 = f32(bitcast<i32>(((_e1951 >> bitcast<u32>((_e1952 & 31u))) & 65535u)));
let _e1959 = local_26.member_1[3u];
let _e1966 = local_27[0u];
let _e1969 = (_e1958 + ((f32(bitcast<i32>(((_e1951 >> bitcast<u32>((_e1959 & 31u))) & 65535u))) - _e1958) * _e1966));
let _e1971 = local_26.member[1u];
let _e1972 = ((_e1366 + _e1363) + _e1971);
let _e1974 = (_e1972 >> bitcast<u32>(1i));
let _e1977 = bitcast<u32>(((_e1972 & 1i) * 16i));
let _e1979 = select(_e1340, _e1974, (_e1974 < _e1340));
let _e1984 = global_2.member[bitcast<u32>(select(0i, _e1979, (_e1979 > 0i)))];
let _e1988 = (_e1974 + 1i);
let _e1990 = select(_e1340, _e1988, (_e1988 < _e1340));
let _e1995 = global_2.member[bitcast<u32>(select(0i, _e1990, (_e1990 > 0i)))];
let _e2002 = ((_e1984 >> bitcast<u32>((_e1977 & 31u))) | ((_e1995 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1977) & 31u))));
let _e2003 = local_26.member_1[2u];
let _e2009 = f32(bitcast<i32>(((_e2002 >> bitcast<u32>((_e2003 & 31u))) & 65535u)));
let _e2010 = local_26.member_1[3u];
let _e2017 = local_27[0u];
let _e2022 = local_26.member[1u];
let _e2023 = ((_e1355 + _e1359) + _e2022);
let _e2025 = (_e2023 >> bitcast<u32>(1i));
let _e2028 = bitcast<u32>(((_e2023 & 1i) * 16i));
let _e2030 = select(_e1340, _e2025, (_e2025 < _e1340));
let _e2035 = global_2.member[bitcast<u32>(select(0i, _e2030, (_e2030 > 0i)))];
let _e2039 = (_e2025 + 1i);
let _e2041 = select(_e1340, _e2039, (_e2039 < _e1340));
let _e2046 = global_2.member[bitcast<u32>(select(0i, _e2041, (_e2041 > 0i)))];
let _e2053 = ((_e2035 >> bitcast<u32>((_e2028 & 31u))) | ((_e2046 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2028) & 31u))));
let _e2054 = local_26.member_1[2u];
let _e2060 = f32(bitcast<i32>(((_e2053 >> bitcast<u32>((_e2054 & 31u))) & 65535u)));
let _e2061 = local_26.member_1[3u];
let _e2068 = local_27[0u];
let _e2071 = (_e2060 + ((f32(bitcast<i32>(((_e2053 >> bitcast<u32>((_e2061 & 31u))) & 65535u))) - _e2060) * _e2068));
let _e2073 = local_26.member[1u];
let _e2074 = ((_e1368 + _e1359) + _e2073);
let _e2076 = (_e2074 >> bitcast<u32>(1i));
let _e2079 = bitcast<u32>(((_e2074 & 1i) * 16i));
let _e2081 = select(_e1340, _e2076, (_e2076 < _e1340));
let _e2086 = global_2.member[bitcast<u32>(select(0i, _e2081, (_e2081 > 0i)))];
let _e2090 = (_e2076 + 1i);
let _e2092 = select(_e1340, _e2090, (_e2090 < _e1340));
let _e2097 = global_2.member[bitcast<u32>(select(0i, _e2092, (_e2092 > 0i)))];
let _e2104 = ((_e2086 >> bitcast<u32>((_e2079 & 31u))) | ((_e2097 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2079) & 31u))));
let _e2105 = local_26.member_1[2u];
let _e2111 = f32(bitcast<i32>(((_e2104 >> bitcast<u32>((_e2105 & 31u))) & 65535u)));
let _e2112 = local_26.member_1[3u];
let _e2119 = local_27[0u];
let _e2122 = (_e2111 + ((f32(bitcast<i32>(((_e2104 >> bitcast<u32>((_e2112 & 31u))) & 65535u))) - _e2111) * _e2119));
let _e2124 = local_26.member[1u];
let _e2125 = ((_e1355 + _e1361) + _e2124);
let _e2127 = (_e2125 >> bitcast<u32>(1i));
let _e2130 = bitcast<u32>(((_e2125 & 1i) * 16i));
let _e2132 = select(_e1340, _e2127, (_e2127 < _e1340));
let _e2137 = global_2.member[bitcast<u32>(select(0i, _e2132, (_e2132 > 0i)))];
let _e2141 = (_e2127 + 1i);
let _e2143 = select(_e1340, _e2141, (_e2141 < _e1340));
let _e2148 = global_2.member[bitcast<u32>(select(0i, _e2143, (_e2143 > 0i)))];
let _e2155 = ((_e2137 >> bitcast<u32>((_e2130 & 31u))) | ((_e2148 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2130) & 31u))));
let _e2156 = local_26.member_1[2u];
let _e2162 = f32(bitcast<i32>(((_e2155 >> bitcast<u32>((_e2156 & 31u))) & 65535u)));
let _e2163 = local_26.member_1[3u];
let _e2170 = local_27[0u];
let _e2175 = local_26.member[1u];
let _e2176 = ((_e1368 + _e1361) + _e2175);
let _e2178 = (_e2176 >> bitcast<u32>(1i));
let _e2181 = bitcast<u32>(((_e2176 & 1i) * 16i));
let _e2183 = select(_e1340, _e2178, (_e2178 < _e1340));
let _e2188 = global_2.member[bitcast<u32>(select(0i, _e2183, (_e2183 > 0i)))];
let _e2192 = (_e2178 + 1i);
let _e2194 = select(_e1340, _e2192, (_e2192 < _e1340));
let _e2199 = global_2.member[bitcast<u32>(select(0i, _e2194, (_e2194 > 0i)))];
let _e2206 = ((_e2188 >> bitcast<u32>((_e2181 & 31u))) | ((_e2199 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2181) & 31u))));
let _e2207 = local_26.member_1[2u];
let _e2213 = f32(bitcast<i32>(((_e2206 >> bitcast<u32>((_e2207 & 31u))) & 65535u)));
let _e2214 = local_26.member_1[3u];
let _e2221 = local_27[0u];
let _e2226 = local_27[1u];
let _e2229 = (_e1491 + ((_e1596 - _e1491) * _e2226));
let _e2230 = local_27[1u];
let _e2233 = (_e1701 + ((_e1806 - _e1701) * _e2230));
let _e2234 = local_27[1u];
let _e2237 = (_e1487 + (((_e1567 + ((_e1574 - _e1567) * _e1589)) - _e1487) * _e2234));
let _e2238 = local_27[1u];
let _e2243 = local_27[2u];
let _e2247 = local_27[1u];
let _e2250 = (_e1495 + (((_e1581 + ((f32(bitcast<i32>(((_e1560 >> bitcast<u32>((_e1582 & 31u))) & 65535u))) - _e1581) * _e1597)) - _e1495) * _e2247));
let _e2251 = local_27[1u];
let _e2255 = local_27[2u];
let _e2259 = local_27[1u];
let _e2262 = (_e1867 + ((_e1491 - _e1867) * _e2259));
let _e2263 = local_27[1u];
let _e2267 = local_27[2u];
let _e2271 = local_27[1u];
let _e2274 = (_e1596 + (((_e1907 + ((f32(bitcast<i32>(((_e1900 >> bitcast<u32>((_e1908 & 31u))) & 65535u))) - _e1907) * _e1915)) - _e1596) * _e2271));
let _e2275 = local_27[1u];
let _e2279 = local_27[2u];
let _e2283 = local_27[1u];
let _e2286 = (_e2071 + (((_e2162 + ((f32(bitcast<i32>(((_e2155 >> bitcast<u32>((_e2163 & 31u))) & 65535u))) - _e2162) * _e2170)) - _e2071) * _e2283));
let _e2287 = local_27[2u];
let _e2291 = local_27[1u];
let _e2295 = local_27[2u];
let _e2299 = local_27[2u];
let _e2306 = global_1.member.member_8.member_6;
let _e2310 = global_1.member.member_8.member_5;
let _e2312 = (((_e2229 + ((_e2233 - _e2229) * _e2299)) - _e2306) * _e2310);
let _e2313 = -(1e9f);
let _e2315 = select(_e2313, _e2312, (_e2312 > _e2313));
let _e2317 = select(1e9f, _e2315, (_e2315 < 1e9f));
let _e2319 = (((_e2237 + (((_e1697 + (((_e1777 + ((_e1784 - _e1777) * _e1799)) - _e1697) * _e2238)) - _e2237) * _e2243)) - _e2306) * _e2310);
let _e2321 = select(_e2313, _e2319, (_e2319 > _e2313));
let _e2323 = select(1e9f, _e2321, (_e2321 < 1e9f));
let _e2325 = (((_e2250 + (((_e1705 + (((_e1791 + ((f32(bitcast<i32>(((_e1770 >> bitcast<u32>((_e1792 & 31u))) & 65535u))) - _e1791) * _e1807)) - _e1705) * _e2251)) - _e2250) * _e2255)) - _e2306) * _e2310);
let _e2327 = select(_e2313, _e2325, (_e2325 > _e2313));
let _e2329 = select(1e9f, _e2327, (_e2327 < 1e9f));
let _e2331 = (((_e2262 + (((_e1969 + ((_e1701 - _e1969) * _e2263)) - _e2262) * _e2267)) - _e2306) * _e2310);
let _e2333 = select(_e2313, _e2331, (_e2331 > _e2313));
let _e2335 = select(1e9f, _e2333, (_e2333 < 1e9f));
let _e2337 = (((_e2274 + (((_e1806 + (((_e2009 + ((f32(bitcast<i32>(((_e2002 >> bitcast<u32>((_e2010 & 31u))) & 65535u))) - _e2009) * _e2017)) - _e1806) * _e2275)) - _e2274) * _e2279)) - _e2306) * _e2310);
let _e2339 = select(_e2313, _e2337, (_e2337 > _e2313));
let _e2341 = select(1e9f, _e2339, (_e2339 < 1e9f));
let _e2343 = (((_e2286 + ((_e2229 - _e2286) * _e2287)) - _e2306) * _e2310);
let _e2345 = select(_e2313, _e2343, (_e2343 > _e2313));
let _e2347 = select(1e9f, _e2345, (_e2345 < 1e9f));
let _e2349 = (((_e2233 + (((_e2122 + (((_e2213 + ((f32(bitcast<i32>(((_e2206 >> bitcast<u32>((_e2214 & 31u))) & 65535u))) - _e2213) * _e2221)) - _e2122) * _e2291)) - _e2233) * _e2295)) - _e2306) * _e2310);
let _e2351 = select(_e2313, _e2349, (_e2349 > _e2313));
let _e2353 = select(1e9f, _e2351, (_e2351 < 1e9f));
local_24 = _e2317;
let _e2354 = local_24;
local_25 = _e2354;
let _e2355 = local_25;
let _e2357 = (bitcast<i32>(_e166) - 1i);
let _e2359 = select(_e2357, 263197i, (263197i < _e2357));
let _e2364 = global_3.member[bitcast<u32>(select(0i, _e2359, (_e2359 > 0i)))];
let _e2365 = bitcast<f32>(_e2364);
let _e2367 = select(_e2357, 263198i, (263198i < _e2357));
let _e2370 = bitcast<u32>(select(0i, _e2367, (_e2367 > 0i)));
let _e2372 = global_3.member[_e2370];
let _e2373 = bitcast<f32>(_e2372);
let _e2375 = select(_e2357, 263199i, (263199i < _e2357));
let _e2380 = global_3.member[bitcast<u32>(select(0i, _e2375, (_e2375 > 0i)))];
let _e2381 = bitcast<f32>(_e2380);
let _e2383 = ((_e2355 - _e2365) * _e2373);
let _e2385 = select(0f, _e2383, (_e2383 > 0f));
let _e2388 = local_25;
let _e2390 = select(_e2357, 263200i, (263200i < _e2357));
let _e2395 = global_3.member[bitcast<u32>(select(0i, _e2390, (_e2390 > 0i)))];
let _e2396 = bitcast<f32>(_e2395);
let _e2398 = select(_e2357, 263201i, (263201i < _e2357));
let _e2403 = global_3.member[bitcast<u32>(select(0i, _e2398, (_e2398 > 0i)))];
let _e2404 = bitcast<f32>(_e2403);
let _e2406 = select(_e2357, 263202i, (263202i < _e2357));
let _e2411 = global_3.member[bitcast<u32>(select(0i, _e2406, (_e2406 > 0i)))];
let _e2412 = bitcast<f32>(_e2411);
let _e2414 = ((_e2388 - _e2396) * _e2404);
let _e2416 = select(0f, _e2414, (_e2414 > 0f));
let _e2420 = local_25;
let _e2422 = select(_e2357, 263203i, (263203i < _e2357));
let _e2427 = global_3.member[bitcast<u32>(select(0i, _e2422, (_e2422 > 0i)))];
let _e2428 = bitcast<f32>(_e2427);
let _e2430 = select(_e2357, 263204i, (263204i < _e2357));
let _e2435 = global_3.member[bitcast<u32>(select(0i, _e2430, (_e2430 > 0i)))];
let _e2436 = bitcast<f32>(_e2435);
let _e2438 = select(_e2357, 263205i, (263205i < _e2357));
let _e2443 = global_3.member[bitcast<u32>(select(0i, _e2438, (_e2438 > 0i)))];
let _e2444 = bitcast<f32>(_e2443);
let _e2446 = ((_e2420 - _e2428) * _e2436);
let _e2448 = select(0f, _e2446, (_e2446 > 0f));
let _e2451 = local_25;
let _e2453 = select(_e2357, 263206i, (263206i < _e2357));
let _e2458 = global_3.member[bitcast<u32>(select(0i, _e2453, (_e2453 > 0i)))];
let _e2459 = bitcast<f32>(_e2458);
let _e2461 = select(_e2357, 263207i, (263207i < _e2357));
let _e2466 = global_3.member[bitcast<u32>(select(0i, _e2461, (_e2461 > 0i)))];
let _e2467 = bitcast<f32>(_e2466);
let _e2469 = select(_e2357, 263208i, (263208i < _e2357));
let _e2474 = global_3.member[bitcast<u32>(select(0i, _e2469, (_e2469 > 0i)))];
let _e2475 = bitcast<f32>(_e2474);
let _e2477 = ((_e2451 - _e2459) * _e2467);
let _e2479 = select(0f, _e2477, (_e2477 > 0f));
let _e2483 = ((select(_e2381, _e2385, (_e2385 < _e2381)) + select(_e2412, _e2416, (_e2416 < _e2412))) + (select(_e2444, _e2448, (_e2448 < _e2444)) + select(_e2475, _e2479, (_e2479 < _e2475))));
let _e2485 = select(0f, _e2483, (_e2483 > 0f));
let _e2487 = select(1023f, _e2485, (_e2485 < 1023f));
let _e2494 = select(0i, select(select(i32(_e2487), i32(-2147483648), (_e2487 < -2147483600f)), 2147483647i, (_e2487 > 2147483500f)), (_e2487 == _e2487));
let _e2498 = (_e2494 - select(0i, 1i, (_e2487 < f32(_e2494))));
let _e2499 = (262147i + _e2498);
let _e2501 = select(_e2357, _e2499, (_e2499 < _e2357));
let _e2507 = global_3.member[bitcast<u32>(select(0i, _e2501, (_e2501 > 0i)))];
let _e2517 = select(_e2357, 262146i, (262146i < _e2357));
let _e2523 = global_3.member[bitcast<u32>(select(0i, _e2517, (_e2517 > 0i)))];
let _e2524 = bitcast<f32>(_e2523);
let _e2525 = (f32((bitcast<i32>((_e2507 & 4095u)) - 2048i)) * _e2524);
let _e2527 = select(_e2357, 262144i, (262144i < _e2357));
let _e2533 = global_3.member[bitcast<u32>(select(0i, _e2527, (_e2527 > 0i)))];
let _e2534 = bitcast<f32>(_e2533);
let _e2536 = select(_e2357, 262145i, (262145i < _e2357));
let _e2542 = global_3.member[bitcast<u32>(select(0i, _e2536, (_e2536 > 0i)))];
let _e2543 = bitcast<f32>(_e2542);
let _e2549 = ((_e2534 + (f32(bitcast<i32>((_e2507 >> bitcast<u32>(12u)))) * _e2543)) + (_e2525 * (_e2483 - f32(_e2498))));
let _e2552 = global_3.member[_e2370];
let _e2554 = local_24;
let _e2557 = local_24;
let _e2560 = local_24;
let _e2564 = select(_e2357, 263209i, (263209i < _e2357));
let _e2570 = global_3.member[bitcast<u32>(select(0i, _e2564, (_e2564 > 0i)))];
let _e2572 = local_24;
let _e2575 = select(_e2357, 263210i, (263210i < _e2357));
let _e2581 = global_3.member[bitcast<u32>(select(0i, _e2575, (_e2575 > 0i)))];
let _e2583 = local_24;
let _e2587 = (_e2525 * select(0f, select(select(select(bitcast<f32>(_e2552), _e2404, (_e2554 >= _e2396)), _e2436, (_e2557 >= _e2428)), _e2467, (_e2560 >= _e2459)), ((_e2572 >= bitcast<f32>(_e2570)) && (_e2583 <= bitcast<f32>(_e2581)))));
if _e1229 {
let _e2594 = ((0.5f * (_e2329 - _e2323)) * _e2587);
let _e2595 = ((0.5f * (_e2341 - _e2335)) * _e2587);
let _e2596 = ((0.5f * (_e2353 - _e2347)) * _e2587);
phi_7363_ = type_32(_e2549, vec3<f32>(_e2594, _e2595, _e2596), vec3<f32>((_e2594 * _e2549), (_e2595 * _e2549), (_e2596 * _e2549)));
} else {
local_22 = _e2323;
let _e2603 = local_22;
local_23 = _e2603;
let _e2604 = local_23;
let _e2606 = ((_e2604 - _e2365) * _e2373);
let _e2608 = select(0f, _e2606, (_e2606 > 0f));
let _e2611 = local_23;
let _e2613 = ((_e2611 - _e2396) * _e2404);
let _e2615 = select(0f, _e2613, (_e2613 > 0f));
let _e2619 = local_23;
let _e2621 = ((_e2619 - _e2428) * _e2436);
let _e2623 = select(0f, _e2621, (_e2621 > 0f));
let _e2626 = local_23;
let _e2628 = ((_e2626 - _e2459) * _e2467);
let _e2630 = select(0f, _e2628, (_e2628 > 0f));
let _e2634 = ((select(_e2381, _e2608, (_e2608 < _e2381)) + select(_e2412, _e2615, (_e2615 < _e2412))) + (select(_e2444, _e2623, (_e2623 < _e2444)) + select(_e2475, _e2630, (_e2630 < _e2475))));
let _e2636 = select(0f, _e2634, (_e2634 > 0f));
let _e2638 = select(1023f, _e2636, (_e2636 < 1023f));
let _e2645 = select(0i, select(select(i32(_e2638), i32(-2147483648), (_e2638 < -2147483600f)), 2147483647i, (_e2638 > 2147483500f)), (_e2638 == _e2638));
let _e2649 = (_e2645 - select(0i, 1i, (_e2638 < f32(_e2645))));
let _e2650 = (262147i + _e2649);
let _e2652 = select(_e2357, _e2650, (_e2650 < _e2357));
let _e2658 = global_3.member[bitcast<u32>(select(0i, _e2652, (_e2652 > 0i)))];
let _e2673 = ((_e2534 + (f32(bitcast<i32>((_e2658 >> bitcast<u32>(12u)))) * _e2543)) + ((f32((bitcast<i32>((_e2658 & 4095u)) - 2048i)) * _e2524) * (_e2634 - f32(_e2649))));
local_20 = _e2329;
let _e2674 = local_20;
local_21 = _e2674;
let _e2675 = local_21;
let _e2677 = ((_e2675 - _e2365) * _e2373);
let _e2679 = select(0f, _e2677, (_e2677 > 0f));
let _e2682 = local_21;
let _e2684 = ((_e2682 - _e2396) * _e2404);
let _e2686 = select(0f, _e2684, (_e2684 > 0f));
let _e2690 = local_21;
let _e2692 = ((_e2690 - _e2428) * _e2436);
let _e2694 = select(0f, _e2692, (_e2692 > 0f));
let _e2697 = local_21;
let _e2699 = ((_e2697 - _e2459) * _e2467);
let _e2701 = select(0f, _e2699, (_e2699 > 0f));
let _e2705 = ((select(_e2381, _e2679, (_e2679 < _e2381)) + select(_e2412, _e2686, (_e2686 < _e2412))) + (select(_e2444, _e2694, (_e2694 < _e2444)) + select(_e2475, _e2701, (_e2701 < _e2475))));
let _e2707 = select(0f, _e2705, (_e2705 > 0f));
let _e2709 = select(1023f, _e2707, (_e2707 < 1023f));
let _e2716 = select(0i, select(select(i32(_e2709), i32(-2147483648), (_e2709 < -2147483600f)), 2147483647i, (_e2709 > 2147483500f)), (_e2709 == _e2709));
let _e2720 = (_e2716 - select(0i, 1i, (_e2709 < f32(_e2716))));
let _e2721 = (262147i + _e2720);
let _e2723 = select(_e2357, _e2721, (_e2721 < _e2357));
let _e2729 = global_3.member[bitcast<u32>(select(0i, _e2723, (_e2723 > 0i)))];
let _e2744 = ((_e2534 + (f32(bitcast<i32>((_e2729 >> bitcast<u32>(12u)))) * _e2543)) + ((f32((bitcast<i32>((_e2729 & 4095u)) - 2048i)) * _e2524) * (_e2705 - f32(_e2720))));
local_18 = _e2335;
let _e2745 = local_18;
local_19 = _e2745;
let _e2746 = local_19;
let _e2748 = ((_e2746 - _e2365) * _e2373);
let _e2750 = select(0f, _e2748, (_e2748 > 0f));
let _e2753 = local_19;
let _e2755 = ((_e2753 - _e2396) * _e2404);
let _e2757 = select(0f, _e2755, (_e2755 > 0f));
let _e2761 = local_19;
let _e2763 = ((_e2761 - _e2428) * _e2436);
let _e2765 = select(0f, _e2763, (_e2763 > 0f));
let _e2768 = local_19;
let _e2770 = ((_e2768 - _e2459) * _e2467);
let _e2772 = select(0f, _e2770, (_e2770 > 0f));
let _e2776 = ((select(_e2381, _e2750, (_e2750 < _e2381)) + select(_e2412, _e2757, (_e2757 < _e2412))) + (select(_e2444, _e2765, (_e2765 < _e2444)) + select(_e2475, _e2772, (_e2772 < _e2475))));
let _e2778 = select(0f, _e2776, (_e2776 > 0f));
let _e2780 = select(1023f, _e2778, (_e2778 < 1023f));
let _e2787 = select(0i, select(select(i32(_e2780), i32(-2147483648), (_e2780 < -2147483600f)), 2147483647i, (_e2780 > 2147483500f)), (_e2780 == _e2780));
let _e2791 = (_e2787 - select(0i, 1i, (_e2780 < f32(_e2787))));
let _e2792 = (262147i + _e2791);
let _e2794 = select(_e2357, _e2792, (_e2792 < _e2357));
let _e2800 = global_3.member[bitcast<u32>(select(0i, _e2794, (_e2794 > 0i)))];
let _e2815 = ((_e2534 + (f32(bitcast<i32>((_e2800 >> bitcast<u32>(12u)))) * _e2543)) + ((f32((bitcast<i32>((_e2800 & 4095u)) - 2048i)) * _e2524) * (_e2776 - f32(_e2791))));
local_16 = _e2341;
let _e2816 = local_16;
local_17 = _e2816;
let _e2817 = local_17;
let _e2819 = ((_e2817 - _e2365) * _e2373);
let _e2821 = select(0f, _e2819, (_e2819 > 0f));
let _e2824 = local_17;
let _e2826 = ((_e2824 - _e2396) * _e2404);
let _e2828 = select(0f, _e2826, (_e2826 > 0f));
let _e2832 = local_17;
let _e2834 = ((_e2832 - _e2428) * _e2436);
let _e2836 = select(0f, _e2834, (_e2834 > 0f));
let _e2839 = local_17;
let _e2841 = ((_e2839 - _e2459) * _e2467);
let _e2843 = select(0f, _e2841, (_e2841 > 0f));
let _e2847 = ((select(_e2381, _e2821, (_e2821 < _e2381)) + select(_e2412, _e2828, (_e2828 < _e2412))) + (select(_e2444, _e2836, (_e2836 < _e2444)) + select(_e2475, _e2843, (_e2843 < _e2475))));
let _e2849 = select(0f, _e2847, (_e2847 > 0f));
let _e2851 = select(1023f, _e2849, (_e2849 < 1023f));
let _e2858 = select(0i, select(select(i32(_e2851), i32(-2147483648), (_e2851 < -2147483600f)), 2147483647i, (_e2851 > 2147483500f)), (_e2851 == _e2851));
let _e2862 = (_e2858 - select(0i, 1i, (_e2851 < f32(_e2858))));
let _e2863 = (262147i + _e2862);
let _e2865 = select(_e2357, _e2863, (_e2863 < _e2357));
let _e2871 = global_3.member[bitcast<u32>(select(0i, _e2865, (_e2865 > 0i)))];
let _e2886 = ((_e2534 + (f32(bitcast<i32>((_e2871 >> bitcast<u32>(12u)))) * _e2543)) + ((f32((bitcast<i32>((_e2871 & 4095u)) - 2048i)) * _e2524) * (_e2847 - f32(_e2862))));
local_14 = _e2347;
let _e2887 = local_14;
local_15 = _e2887;
let _e2888 = local_15;
let _e2890 = ((_e2888 - _e2365) * _e2373);
let _e2892 = select(0f, _e2890, (_e2890 > 0f));
let _e2895 = local_15;
let _e2897 = ((_e2895 - _e2396) * _e2404);
let _e2899 = select(0f, _e2897, (_e2897 > 0f));
let _e2903 = local_15;
let _e2905 = ((_e2903 - _e2428) * _e2436);
let _e2907 = select(0f, _e2905, (_e2905 > 0f));
let _e2910 = local_15;
let _e2912 = ((_e2910 - _e2459) * _e2467);
let _e2914 = select(0f, _e2912, (_e2912 > 0f));
let _e2918 = ((select(_e2381, _e2892, (_e2892 < _e2381)) + select(_e2412, _e2899, (_e2899 < _e2412))) + (select(_e2444, _e2907, (_e2907 < _e2444)) + select(_e2475, _e2914, (_e2914 < _e2475))));
let _e2920 = select(0f, _e2918, (_e2918 > 0f));
let _e2922 = select(1023f, _e2920, (_e2920 < 1023f));
let _e2929 = select(0i, select(select(i32(_e2922), i32(-2147483648), (_e2922 < -2147483600f)), 2147483647i, (_e2922 > 2147483500f)), (_e2922 == _e2922));
let _e2933 = (_e2929 - select(0i, 1i, (_e2922 < f32(_e2929))));
let _e2934 = (262147i + _e2933);
let _e2936 = select(_e2357, _e2934, (_e2934 < _e2357));
let _e2942 = global_3.member[bitcast<u32>(select(0i, _e2936, (_e2936 > 0i)))];
let _e2957 = ((_e2534 + (f32(bitcast<i32>((_e2942 >> bitcast<u32>(12u)))) * _e2543)) + ((f32((bitcast<i32>((_e2942 & 4095u)) - 2048i)) * _e2524) * (_e2918 - f32(_e2933))));
local_12 = _e2353;
let _e2958 = local_12;
local_13 = _e2958;
let _e2959 = local_13;
let _e2961 = ((_e2959 - _e2365) * _e2373);
let _e2963 = select(0f, _e2961, (_e2961 > 0f));
let _e2966 = local_13;
let _e2968 = ((_e2966 - _e2396) * _e2404);
let _e2970 = select(0f, _e2968, (_e2968 > 0f));
let _e2974 = local_13;
let _e2976 = ((_e2974 - _e2428) * _e2436);
let _e2978 = select(0f, _e2976, (_e2976 > 0f));
let _e2981 = local_13;
let _e2983 = ((_e2981 - _e2459) * _e2467);
let _e2985 = select(0f, _e2983, (_e2983 > 0f));
let _e2989 = ((select(_e2381, _e2963, (_e2963 < _e2381)) + select(_e2412, _e2970, (_e2970 < _e2412))) + (select(_e2444, _e2978, (_e2978 < _e2444)) + select(_e2475, _e2985, (_e2985 < _e2475))));
let _e2991 = select(0f, _e2989, (_e2989 > 0f));
let _e2993 = select(1023f, _e2991, (_e2991 < 1023f));
let _e3000 = select(0i, select(select(i32(_e2993), i32(-2147483648), (_e2993 < -2147483600f)), 2147483647i, (_e2993 > 2147483500f)), (_e2993 == _e2993));
let _e3004 = (_e3000 - select(0i, 1i, (_e2993 < f32(_e3000))));
let _e3005 = (262147i + _e3004);
let _e3007 = select(_e2357, _e3005, (_e3005 < _e2357));
let _e3013 = global_3.member[bitcast<u32>(select(0i, _e3007, (_e3007 > 0i)))];
let _e3028 = ((_e2534 + (f32(bitcast<i32>((_e3013 >> bitcast<u32>(12u)))) * _e2543)) + ((f32((bitcast<i32>((_e3013 & 4095u)) - 2048i)) * _e2524) * (_e2989 - f32(_e3004))));
let _e3029 = (_e2744 - _e2673);
let _e3031 = (_e2886 - _e2815);
let _e3033 = (_e3028 - _e2957);
phi_7363_ = type_32(_e2549, vec3<f32>((0.5f * _e3029), (0.5f * _e3031), (0.5f * _e3033)), vec3<f32>((0.25f * (_e3029 * (_e2744 + _e2673))), (0.25f * (_e3031 * (_e2886 + _e2815))), (0.25f * (_e3033 * (_e3028 + _e2957)))));
}
let _e3048 = phi_7363_;
let _e3063 = select(0f, 1f, ((((((_e1209 >= -0.5f) && (_e1209 <= _e1236)) && (_e1215 >= -0.5f)) && (_e1215 <= _e1246)) && (_e1221 >= -0.5f)) && (_e1221 <= _e1256)));
let _e3065 = (0.5f * (_e2329 - _e2323));
let _e3067 = (0.5f * (_e2341 - _e2335));
let _e3069 = (0.5f * (_e2353 - _e2347));
let _e3075 = global_1.member.member_8.member.member.member;
let _e3081 = global_1.member.member_8.member.member.member_1;
let _e3087 = global_1.member.member_8.member.member.member_2;
let _e3093 = global_1.member.member_8.member_1.member.member;
let _e3099 = global_1.member.member_8.member_1.member.member_1;
let _e3105 = global_1.member.member_8.member_1.member.member_2;
let _e3111 = global_1.member.member_8.member_2.member.member;
let _e3117 = global_1.member.member_8.member_2.member.member_1;
let _e3123 = global_1.member.member_8.member_2.member.member_2;
phi_8065_ = type_33(_e2317, vec3<f32>(((((_e3075 * _e3065) + (_e3093 * _e3067)) + (_e3111 * _e3069)) * _e3063), ((((_e3081 * _e3065) + (_e3099 * _e3067)) + (_e3117 * _e3069)) * _e3063), ((((_e3087 * _e3065) + (_e3105 * _e3067)) + (_e3123 * _e3069)) * _e3063)), _e3048.member, vec3<f32>(((((_e3075 * _e3048.member_2.x) + (_e3093 * _e3048.member_2.y)) + (_e3111 * _e3048.member_2.z)) * _e3063), ((((_e3081 * _e3048.member_2.x) + (_e3099 * _e3048.member_2.y)) + (_e3117 * _e3048.member_2.z)) * _e3063), ((((_e3087 * _e3048.member_2.x) + (_e3105 * _e3048.member_2.y)) + (_e3123 * _e3048.member_2.z)) * _e3063)), vec3<f32>(((((_e3075 * _e3048.member_1.x) + (_e3093 * _e3048.member_1.y)) + (_e3111 * _e3048.member_1.z)) * _e3063), ((((_e3081 * _e3048.member_1.x) + (_e3099 * _e3048.member_1.y)) + (_e3117 * _e3048.member_1.z)) * _e3063), ((((_e3087 * _e3048.member_1.x) + (_e3105 * _e3048.member_1.y)) + (_e3123 * _e3048.member_1.z)) * _e3063)));
} else {
let _e3192 = global_1.member.member_8.member_3.member;
let _e3193 = (_e3192 - 0.5f);
let _e3195 = select(-0.5f, _e1209, (_e1209 > -0.5f));
let _e3197 = select(_e3193, _e3195, (_e3195 < _e3193));
let _e3202 = global_1.member.member_8.member_3.member_1;
let _e3203 = (_e3202 - 0.5f);
let _e3205 = select(-0.5f, _e1215, (_e1215 > -0.5f));
let _e3207 = select(_e3203, _e3205, (_e3205 < _e3203));
let _e3212 = global_1.member.member_8.member_3.member_2;
let _e3213 = (_e3212 - 0.5f);
let _e3215 = select(-0.5f, _e1221, (_e1221 > -0.5f));
let _e3217 = select(_e3213, _e3215, (_e3215 < _e3213));
let _e3219 = select(-1f, _e3197, (_e3197 > -1f));
let _e3221 = select(_e3192, _e3219, (_e3219 < _e3192));
let _e3228 = select(0i, select(select(i32(_e3221), i32(-2147483648), (_e3221 < -2147483600f)), 2147483647i, (_e3221 > 2147483500f)), (_e3221 == _e3221));
let _e3232 = (_e3228 - select(0i, 1i, (_e3221 < f32(_e3228))));
let _e3234 = select(-1f, _e3207, (_e3207 > -1f));
let _e3236 = select(_e3202, _e3234, (_e3234 < _e3202));
let _e3243 = select(0i, select(select(i32(_e3236), i32(-2147483648), (_e3236 < -2147483600f)), 2147483647i, (_e3236 > 2147483500f)), (_e3236 == _e3236));
let _e3247 = (_e3243 - select(0i, 1i, (_e3236 < f32(_e3243))));
let _e3249 = select(-1f, _e3217, (_e3217 > -1f));
let _e3251 = select(_e3212, _e3249, (_e3249 < _e3212));
let _e3258 = select(0i, select(select(i32(_e3251), i32(-2147483648), (_e3251 < -2147483600f)), 2147483647i, (_e3251 > 2147483500f)), (_e3251 == _e3251));
let _e3262 = (_e3258 - select(0i, 1i, (_e3251 < f32(_e3258))));
let _e3266 = global_1.member.member_8.member_7;
let _e3270 = global_1.member.member_8.member_8;
let _e3271 = (_e3232 + 1i);
let _e3272 = (_e3247 + 1i);
let _e3273 = (_e3262 + 1i);
let _e3278 = global_1.member.member_8.member_11.member;
let _e3284 = global_1.member.member_8.member_11.member_1;
let _e3295 = ((_e3271 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3278) * ((_e3272 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3284) * (_e3273 >> bitcast<u32>(4i))))));
let _e3297 = (bitcast<i32>(_e161) - 1i);
let _e3299 = select(_e3297, _e3295, (_e3295 < _e3297));
let _e3305 = global_2.member[bitcast<u32>(select(0i, _e3299, (_e3299 > 0i)))];
let _e3307 = (_e3271 & 15i);
let _e3310 = ((_e3272 & 15i) * _e3266);
let _e3312 = (bitcast<i32>(_e3305) + ((_e3273 & 15i) * _e3270));
let _e3316 = (_e3310 + _e3266);
let _e3318 = (_e3310 + (2i * _e3266));
let _e3319 = (_e3312 + _e3270);
let _e3321 = (_e3312 + (2i * _e3270));
local_10 = type_29(array<i32, 4>(_e3307, (_e3307 + 1i), (_e3307 + 2i), (_e3307 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_11 = vec3<f32>((_e3197 - f32(_e3232)), (_e3207 - f32(_e3247)), (_e3217 - f32(_e3262)));
let _e3335 = local_10.member[1u];
let _e3336 = ((_e3319 + _e3316) + _e3335);
let _e3338 = (_e3336 >> bitcast<u32>(1i));
let _e3341 = bitcast<u32>(((_e3336 & 1i) * 16i));
let _e3343 = select(_e3297, _e3338, (_e3338 < _e3297));
let _e3348 = global_2.member[bitcast<u32>(select(0i, _e3343, (_e3343 > 0i)))];
let _e3352 = (_e3338 + 1i);
let _e3354 = select(_e3297, _e3352, (_e3352 < _e3297));
let _e3359 = global_2.member[bitcast<u32>(select(0i, _e3354, (_e3354 > 0i)))];
let _e3366 = ((_e3348 >> bitcast<u32>((_e3341 & 31u))) | ((_e3359 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3341) & 31u))));
let _e3369 = local_10.member_1[2u];
let _e3375 = f32(bitcast<i32>(((_e3366 >> bitcast<u32>((_e3369 & 31u))) & 65535u)));
let _e3378 = local_10.member_1[3u];
let _e3385 = local_11[0u];
let _e3388 = (_e3375 + ((f32(bitcast<i32>(((_e3366 >> bitcast<u32>((_e3378 & 31u))) & 65535u))) - _e3375) * _e3385));
let _e3390 = local_10.member[1u];
let _e3391 = ((_e3319 + _e3318) + _e3390);
let _e3393 = (_e3391 >> bitcast<u32>(1i));
let _e3396 = bitcast<u32>(((_e3391 & 1i) * 16i));
let _e3398 = select(_e3297, _e3393, (_e3393 < _e3297));
let _e3403 = global_2.member[bitcast<u32>(select(0i, _e3398, (_e3398 > 0i)))];
let _e3407 = (_e3393 + 1i);
let _e3409 = select(_e3297, _e3407, (_e3407 < _e3297));
let _e3414 = global_2.member[bitcast<u32>(select(0i, _e3409, (_e3409 > 0i)))];
let _e3421 = ((_e3403 >> bitcast<u32>((_e3396 & 31u))) | ((_e3414 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3396) & 31u))));
let _e3422 = local_10.member_1[2u];
let _e3428 = f32(bitcast<i32>(((_e3421 >> bitcast<u32>((_e3422 & 31u))) & 65535u)));
let _e3429 = local_10.member_1[3u];
let _e3436 = local_11[0u];
let _e3441 = local_11[1u];
let _e3444 = (_e3388 + (((_e3428 + ((f32(bitcast<i32>(((_e3421 >> bitcast<u32>((_e3429 & 31u))) & 65535u))) - _e3428) * _e3436)) - _e3388) * _e3441));
let _e3446 = local_10.member[1u];
let _e3447 = ((_e3321 + _e3316) + _e3446);
let _e3449 = (_e3447 >> bitcast<u32>(1i));
let _e3452 = bitcast<u32>(((_e3447 & 1i) * 16i));
let _e3454 = select(_e3297, _e3449, (_e3449 < _e3297));
let _e3459 = global_2.member[bitcast<u32>(select(0i, _e3454, (_e3454 > 0i)))];
let _e3463 = (_e3449 + 1i);
let _e3465 = select(_e3297, _e3463, (_e3463 < _e3297));
let _e3470 = global_2.member[bitcast<u32>(select(0i, _e3465, (_e3465 > 0i)))];
let _e3477 = ((_e3459 >> bitcast<u32>((_e3452 & 31u))) | ((_e3470 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3452) & 31u))));
let _e3478 = local_10.member_1[2u];
let _e3484 = f32(bitcast<i32>(((_e3477 >> bitcast<u32>((_e3478 & 31u))) & 65535u)));
let _e3485 = local_10.member_1[3u];
let _e3492 = local_11[0u];
let _e3495 = (_e3484 + ((f32(bitcast<i32>(((_e3477 >> bitcast<u32>((_e3485 & 31u))) & 65535u))) - _e3484) * _e3492));
let _e3497 = local_10.member[1u];
let _e3498 = ((_e3321 + _e3318) + _e3497);
let _e3500 = (_e3498 >> bitcast<u32>(1i));
let _e3503 = bitcast<u32>(((_e3498 & 1i) * 16i));
let _e3505 = select(_e3297, _e3500, (_e3500 < _e3297));
let _e3510 = global_2.member[bitcast<u32>(select(0i, _e3505, (_e3505 > 0i)))];
let _e3514 = (_e3500 + 1i);
let _e3516 = select(_e3297, _e3514, (_e3514 < _e3297));
let _e3521 = global_2.member[bitcast<u32>(select(0i, _e3516, (_e3516 > 0i)))];
let _e3528 = ((_e3510 >> bitcast<u32>((_e3503 & 31u))) | ((_e3521 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3503) & 31u))));
let _e3529 = local_10.member_1[2u];
let _e3535 = f32(bitcast<i32>(((_e3528 >> bitcast<u32>((_e3529 & 31u))) & 65535u)));
let _e3536 = local_10.member_1[3u];
let _e3543 = local_11[0u];
let _e3547 = local_11[1u];
let _e3552 = local_11[2u];
let _e3559 = global_1.member.member_8.member_6;
let _e3563 = global_1.member.member_8.member_5;
let _e3565 = (((_e3444 + (((_e3495 + (((_e3535 + ((f32(bitcast<i32>(((_e3528 >> bitcast<u32>((_e3536 & 31u))) & 65535u))) - _e3535) * _e3543)) - _e3495) * _e3547)) - _e3444) * _e3552)) - _e3559) * _e3563);
let _e3566 = -(1e9f);
let _e3568 = select(_e3566, _e3565, (_e3565 > _e3566));
phi_8065_ = type_33(select(1e9f, _e3568, (_e3568 < 1e9f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e3573 = phi_8065_;
let _e3578 = global_1.member.member_8.member_3.member;
let _e3579 = (_e3578 - 0.5f);
let _e3581 = select(-0.5f, _e1173, (_e1173 > -0.5f));
let _e3583 = select(_e3579, _e3581, (_e3581 < _e3579));
let _e3588 = global_1.member.member_8.member_3.member_1;
let _e3589 = (_e3588 - 0.5f);
let _e3591 = select(-0.5f, _e1188, (_e1188 > -0.5f));
let _e3593 = select(_e3589, _e3591, (_e3591 < _e3589));
let _e3598 = global_1.member.member_8.member_3.member_2;
let _e3599 = (_e3598 - 0.5f);
let _e3601 = select(-0.5f, _e1203, (_e1203 > -0.5f));
let _e3603 = select(_e3599, _e3601, (_e3601 < _e3599));
let _e3605 = select(-1f, _e3583, (_e3583 > -1f));
let _e3607 = select(_e3578, _e3605, (_e3605 < _e3578));
let _e3614 = select(0i, select(select(i32(_e3607), i32(-2147483648), (_e3607 < -2147483600f)), 2147483647i, (_e3607 > 2147483500f)), (_e3607 == _e3607));
let _e3618 = (_e3614 - select(0i, 1i, (_e3607 < f32(_e3614))));
let _e3620 = select(-1f, _e3593, (_e3593 > -1f));
let _e3622 = select(_e3588, _e3620, (_e3620 < _e3588));
let _e3629 = select(0i, select(select(i32(_e3622), i32(-2147483648), (_e3622 < -2147483600f)), 2147483647i, (_e3622 > 2147483500f)), (_e3622 == _e3622));
let _e3633 = (_e3629 - select(0i, 1i, (_e3622 < f32(_e3629))));
let _e3635 = select(-1f, _e3603, (_e3603 > -1f));
let _e3637 = select(_e3598, _e3635, (_e3635 < _e3598));
let _e3644 = select(0i, select(select(i32(_e3637), i32(-2147483648), (_e3637 < -2147483600f)), 2147483647i, (_e3637 > 2147483500f)), (_e3637 == _e3637));
let _e3648 = (_e3644 - select(0i, 1i, (_e3637 < f32(_e3644))));
let _e3652 = global_1.member.member_8.member_7;
let _e3656 = global_1.member.member_8.member_8;
let _e3657 = (_e3618 + 1i);
let _e3658 = (_e3633 + 1i);
let _e3659 = (_e3648 + 1i);
let _e3664 = global_1.member.member_8.member_11.member;
let _e3665 = bitcast<i32>(_e3664);
let _e3670 = global_1.member.member_8.member_11.member_1;
let _e3671 = bitcast<i32>(_e3670);
let _e3681 = ((_e3657 >> bitcast<u32>(4i)) + (_e3665 * ((_e3658 >> bitcast<u32>(4i)) + (_e3671 * (_e3659 >> bitcast<u32>(4i))))));
let _e3683 = (bitcast<i32>(_e161) - 1i);
let _e3685 = select(_e3683, _e3681, (_e3681 < _e3683));
let _e3691 = global_2.member[bitcast<u32>(select(0i, _e3685, (_e3685 > 0i)))];
let _e3693 = (_e3657 & 15i);
let _e3696 = ((_e3658 & 15i) * _e3652);
let _e3698 = (bitcast<i32>(_e3691) + ((_e3659 & 15i) * _e3656));
let _e3702 = (_e3696 + _e3652);
let _e3703 = (2i * _e3652);
let _e3704 = (_e3696 + _e3703);
let _e3705 = (_e3698 + _e3656);
let _e3706 = (2i * _e3656);
let _e3707 = (_e3698 + _e3706);
local_8 = type_29(array<i32, 4>(_e3693, (_e3693 + 1i), (_e3693 + 2i), (_e3693 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_9 = vec3<f32>((_e3583 - f32(_e3618)), (_e3593 - f32(_e3633)), (_e3603 - f32(_e3648)));
let _e3721 = local_8.member[1u];
let _e3722 = ((_e3705 + _e3702) + _e3721);
let _e3724 = (_e3722 >> bitcast<u32>(1i));
let _e3727 = bitcast<u32>(((_e3722 & 1i) * 16i));
let _e3729 = select(_e3683, _e3724, (_e3724 < _e3683));
let _e3734 = global_2.member[bitcast<u32>(select(0i, _e3729, (_e3729 > 0i)))];
let _e3738 = (_e3724 + 1i);
let _e3740 = select(_e3683, _e3738, (_e3738 < _e3683));
let _e3745 = global_2.member[bitcast<u32>(select(0i, _e3740, (_e3740 > 0i)))];
let _e3752 = ((_e3734 >> bitcast<u32>((_e3727 & 31u))) | ((_e3745 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3727) & 31u))));
let _e3755 = local_8.member_1[2u];
let _e3761 = f32(bitcast<i32>(((_e3752 >> bitcast<u32>((_e3755 & 31u))) & 65535u)));
let _e3764 = local_8.member_1[3u];
let _e3771 = local_9[0u];
let _e3774 = (_e3761 + ((f32(bitcast<i32>(((_e3752 >> bitcast<u32>((_e3764 & 31u))) & 65535u))) - _e3761) * _e3771));
let _e3776 = local_8.member[1u];
let _e3777 = ((_e3705 + _e3704) + _e3776);
let _e3779 = (_e3777 >> bitcast<u32>(1i));
let _e3782 = bitcast<u32>(((_e3777 & 1i) * 16i));
let _e3784 = select(_e3683, _e3779, (_e3779 < _e3683));
let _e3789 = global_2.member[bitcast<u32>(select(0i, _e3784, (_e3784 > 0i)))];
let _e3793 = (_e3779 + 1i);
let _e3795 = select(_e3683, _e3793, (_e3793 < _e3683));
let _e3800 = global_2.member[bitcast<u32>(select(0i, _e3795, (_e3795 > 0i)))];
let _e3807 = ((_e3789 >> bitcast<u32>((_e3782 & 31u))) | ((_e3800 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3782) & 31u))));
let _e3808 = local_8.member_1[2u];
let _e3814 = f32(bitcast<i32>(((_e3807 >> bitcast<u32>((_e3808 & 31u))) & 65535u)));
let _e3815 = local_8.member_1[3u];
let _e3822 = local_9[0u];
let _e3827 = local_9[1u];
let _e3830 = (_e3774 + (((_e3814 + ((f32(bitcast<i32>(((_e3807 >> bitcast<u32>((_e3815 & 31u))) & 65535u))) - _e3814) * _e3822)) - _e3774) * _e3827));
let _e3832 = local_8.member[1u];
let _e3833 = ((_e3707 + _e3702) + _e3832);
let _e3835 = (_e3833 >> bitcast<u32>(1i));
let _e3838 = bitcast<u32>(((_e3833 & 1i) * 16i));
let _e3840 = select(_e3683, _e3835, (_e3835 < _e3683));
let _e3845 = global_2.member[bitcast<u32>(select(0i, _e3840, (_e3840 > 0i)))];
let _e3849 = (_e3835 + 1i);
let _e3851 = select(_e3683, _e3849, (_e3849 < _e3683));
let _e3856 = global_2.member[bitcast<u32>(select(0i, _e3851, (_e3851 > 0i)))];
let _e3863 = ((_e3845 >> bitcast<u32>((_e3838 & 31u))) | ((_e3856 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3838) & 31u))));
let _e3864 = local_8.member_1[2u];
let _e3870 = f32(bitcast<i32>(((_e3863 >> bitcast<u32>((_e3864 & 31u))) & 65535u)));
let _e3871 = local_8.member_1[3u];
let _e3878 = local_9[0u];
let _e3881 = (_e3870 + ((f32(bitcast<i32>(((_e3863 >> bitcast<u32>((_e3871 & 31u))) & 65535u))) - _e3870) * _e3878));
let _e3883 = local_8.member[1u];
let _e3884 = ((_e3707 + _e3704) + _e3883);
let _e3886 = (_e3884 >> bitcast<u32>(1i));
let _e3889 = bitcast<u32>(((_e3884 & 1i) * 16i));
let _e3891 = select(_e3683, _e3886, (_e3886 < _e3683));
let _e3896 = global_2.member[bitcast<u32>(select(0i, _e3891, (_e3891 > 0i)))];
let _e3900 = (_e3886 + 1i);
let _e3902 = select(_e3683, _e3900, (_e3900 < _e3683));
let _e3907 = global_2.member[bitcast<u32>(select(0i, _e3902, (_e3902 > 0i)))];
let _e3914 = ((_e3896 >> bitcast<u32>((_e3889 & 31u))) | ((_e3907 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3889) & 31u))));
let _e3915 = local_8.member_1[2u];
let _e3921 = f32(bitcast<i32>(((_e3914 >> bitcast<u32>((_e3915 & 31u))) & 65535u)));
let _e3922 = local_8.member_1[3u];
let _e3929 = local_9[0u];
let _e3933 = local_9[1u];
let _e3938 = local_9[2u];
let _e3945 = global_1.member.member_8.member_6;
let _e3949 = global_1.member.member_8.member_5;
let _e3951 = (((_e3830 + (((_e3881 + (((_e3921 + ((f32(bitcast<i32>(((_e3914 >> bitcast<u32>((_e3922 & 31u))) & 65535u))) - _e3921) * _e3929)) - _e3881) * _e3933)) - _e3830) * _e3938)) - _e3945) * _e3949);
let _e3952 = -(1e9f);
let _e3954 = select(_e3952, _e3951, (_e3951 > _e3952));
let _e3956 = select(1e9f, _e3954, (_e3954 < 1e9f));
let _e3959 = global_1.member.member_1;
let _e3961 = ((_e3959 & 16u) == 0u);
if _e3961 {
phi_8954_ = type_7(1f, 1f, 1f);
} else {
let _e3965 = global_1.member.member_16.member;
let _e3976 = ((((_e3965.member.member * _e1130) + (_e3965.member.member_1 * _e1143)) + (_e3965.member.member_2 * _e1108)) + _e3965.member_1);
let _e3982 = ((((_e3965.member.member * _e1153) + (_e3965.member.member_1 * _e1158)) + (_e3965.member.member_2 * _e1147)) + _e3965.member_1);
let _e3984 = select(_e3982, _e3976, (_e3976 < _e3982));
let _e3986 = select(_e3982, _e3976, (_e3976 > _e3982));
let _e3988 = (_e3986 - _e3984);
let _e3991 = (-(_e3984) / select(1e-30f, _e3988, (_e3988 > 1e-30f)));
let _e3993 = select(0f, _e3991, (_e3991 > 0f));
let _e3999 = select(select(select(1f, _e3993, (_e3993 < 1f)), 1f, (_e3986 <= 0f)), 0f, (_e3984 > 0f));
let _e4004 = global_1.member.member_16.member_1;
let _e4005 = (_e4004 != 0u);
let _e4015 = global_1.member.member_17.member;
let _e4026 = ((((_e4015.member.member * _e1130) + (_e4015.member.member_1 * _e1143)) + (_e4015.member.member_2 * _e1108)) + _e4015.member_1);
let _e4032 = ((((_e4015.member.member * _e1153) + (_e4015.member.member_1 * _e1158)) + (_e4015.member.member_2 * _e1147)) + _e4015.member_1);
let _e4034 = select(_e4032, _e4026, (_e4026 < _e4032));
let _e4036 = select(_e4032, _e4026, (_e4026 > _e4032));
let _e4038 = (_e4036 - _e4034);
let _e4041 = (-(_e4034) / select(1e-30f, _e4038, (_e4038 > 1e-30f)));
let _e4043 = select(0f, _e4041, (_e4041 > 0f));
let _e4049 = select(select(select(1f, _e4043, (_e4043 < 1f)), 1f, (_e4036 <= 0f)), 0f, (_e4034 > 0f));
let _e4054 = global_1.member.member_17.member_1;
let _e4055 = (_e4054 != 0u);
let _e4065 = global_1.member.member_18.member;
let _e4076 = ((((_e4065.member.member * _e1130) + (_e4065.member.member_1 * _e1143)) + (_e4065.member.member_2 * _e1108)) + _e4065.member_1);
let _e4082 = ((((_e4065.member.member * _e1153) + (_e4065.member.member_1 * _e1158)) + (_e4065.member.member_2 * _e1147)) + _e4065.member_1);
let _e4084 = select(_e4082, _e4076, (_e4076 < _e4082));
let _e4086 = select(_e4082, _e4076, (_e4076 > _e4082));
let _e4088 = (_e4086 - _e4084);
let _e4091 = (-(_e4084) / select(1e-30f, _e4088, (_e4088 > 1e-30f)));
let _e4093 = select(0f, _e4091, (_e4091 > 0f));
let _e4099 = select(select(select(1f, _e4093, (_e4093 < 1f)), 1f, (_e4086 <= 0f)), 0f, (_e4084 > 0f));
let _e4104 = global_1.member.member_18.member_1;
let _e4105 = (_e4104 != 0u);
let _e4115 = global_1.member.member_19.member;
let _e4126 = ((((_e4115.member.member * _e1130) + (_e4115.member.member_1 * _e1143)) + (_e4115.member.member_2 * _e1108)) + _e4115.member_1);
let _e4132 = ((((_e4115.member.member * _e1153) + (_e4115.member.member_1 * _e1158)) + (_e4115.member.member_2 * _e1147)) + _e4115.member_1);
let _e4134 = select(_e4132, _e4126, (_e4126 < _e4132));
let _e4136 = select(_e4132, _e4126, (_e4126 > _e4132));
let _e4138 = (_e4136 - _e4134);
let _e4141 = (-(_e4134) / select(1e-30f, _e4138, (_e4138 > 1e-30f)));
let _e4143 = select(0f, _e4141, (_e4141 > 0f));
let _e4149 = select(select(select(1f, _e4143, (_e4143 < 1f)), 1f, (_e4136 <= 0f)), 0f, (_e4134 > 0f));
let _e4154 = global_1.member.member_19.member_1;
let _e4155 = (_e4154 != 0u);
phi_8954_ = type_7(((((1f * _e3999) * _e4049) * _e4099) * _e4149), ((((1f * select(1f, _e3999, _e4005)) * select(1f, _e4049, _e4055)) * select(1f, _e4099, _e4105)) * select(1f, _e4149, _e4155)), ((((1f * select(1f, 0f, (_e4005 && (_e3982 > 0f)))) * select(1f, 0f, (_e4055 && (_e4032 > 0f)))) * select(1f, 0f, (_e4105 && (_e4082 > 0f)))) * select(1f, 0f, (_e4155 && (_e4132 > 0f)))));
}
let _e4164 = phi_8954_;
let _e4165 = (_e1209 - _e1173);
let _e4169 = (bitcast<f32>((bitcast<u32>(_e4165) & 2147483647u)) < 1e-12f);
let _e4171 = (1f / select(_e4165, 1f, _e4169));
let _e4172 = (-0.5f - _e1173);
let _e4173 = (_e4172 * _e4171);
let _e4175 = ((_e3579 - _e1173) * _e4171);
let _e4181 = select(_e4175, _e4173, (_e4173 < _e4175));
let _e4183 = select(0f, _e4181, (_e4181 > 0f));
let _e4186 = select(select(1f, _e4183, (_e4183 < 1f)), select(2f, 0f, ((_e1173 >= -0.5f) && (_e1173 <= _e3579))), _e4169);
let _e4188 = select(_e4175, _e4173, (_e4173 > _e4175));
let _e4190 = select(0f, _e4188, (_e4188 > 0f));
let _e4193 = select(select(1f, _e4190, (_e4190 < 1f)), 1f, _e4169);
let _e4194 = (_e1215 - _e1188);
let _e4198 = (bitcast<f32>((bitcast<u32>(_e4194) & 2147483647u)) < 1e-12f);
let _e4200 = (1f / select(_e4194, 1f, _e4198));
let _e4201 = (-0.5f - _e1188);
let _e4202 = (_e4201 * _e4200);
let _e4204 = ((_e3589 - _e1188) * _e4200);
let _e4210 = select(_e4204, _e4202, (_e4202 < _e4204));
let _e4212 = select(0f, _e4210, (_e4210 > 0f));
let _e4215 = select(select(1f, _e4212, (_e4212 < 1f)), select(2f, 0f, ((_e1188 >= -0.5f) && (_e1188 <= _e3589))), _e4198);
let _e4217 = select(_e4204, _e4202, (_e4202 > _e4204));
let _e4219 = select(0f, _e4217, (_e4217 > 0f));
let _e4222 = select(select(1f, _e4219, (_e4219 < 1f)), 1f, _e4198);
let _e4223 = (_e1221 - _e1203);
let _e4227 = (bitcast<f32>((bitcast<u32>(_e4223) & 2147483647u)) < 1e-12f);
let _e4229 = (1f / select(_e4223, 1f, _e4227));
let _e4230 = (-0.5f - _e1203);
let _e4231 = (_e4230 * _e4229);
let _e4233 = ((_e3599 - _e1203) * _e4229);
let _e4239 = select(_e4233, _e4231, (_e4231 < _e4233));
let _e4241 = select(0f, _e4239, (_e4239 > 0f));
let _e4244 = select(select(1f, _e4241, (_e4241 < 1f)), select(2f, 0f, ((_e1203 >= -0.5f) && (_e1203 <= _e3599))), _e4227);
let _e4246 = select(_e4233, _e4231, (_e4231 > _e4233));
let _e4248 = select(0f, _e4246, (_e4246 > 0f));
let _e4251 = select(select(1f, _e4248, (_e4248 < 1f)), 1f, _e4227);
let _e4253 = select(_e4222, _e4193, (_e4193 < _e4222));
let _e4257 = select(_e4215, _e4186, (_e4186 > _e4215));
let _e4260 = (select(_e4251, _e4253, (_e4253 < _e4251)) - select(_e4244, _e4257, (_e4257 > _e4244)));
let _e4263 = (_e1153 - _e1130);
let _e4264 = (_e1158 - _e1143);
let _e4265 = (_e1147 - _e1108);
let _e4270 = (((_e4263 * _e4263) + (_e4264 * _e4264)) + (_e4265 * _e4265));
let _e4278 = global_1.member.member_7.member_3;
let _e4279 = ((sqrt(select(0f, _e4270, (_e4270 > 0f))) * select(0f, _e4260, (_e4260 > 0f))) * _e4278);
if (((_e176.member_2 == 3u) || (_e176.member_2 == 4u)) || _e1223) {
local_7 = _e3956;
let _e4285 = local_7;
let _e4287 = (bitcast<i32>(_e166) - 1i);
let _e4289 = select(_e4287, 263171i, (263171i < _e4287));
let _e4294 = global_3.member[bitcast<u32>(select(0i, _e4289, (_e4289 > 0i)))];
let _e4295 = bitcast<f32>(_e4294);
let _e4297 = select(_e4287, 263172i, (263172i < _e4287));
let _e4302 = global_3.member[bitcast<u32>(select(0i, _e4297, (_e4297 > 0i)))];
let _e4303 = bitcast<f32>(_e4302);
let _e4305 = select(_e4287, 263173i, (263173i < _e4287));
let _e4310 = global_3.member[bitcast<u32>(select(0i, _e4305, (_e4305 > 0i)))];
let _e4311 = bitcast<f32>(_e4310);
let _e4313 = ((_e4285 - _e4295) * _e4303);
let _e4315 = select(0f, _e4313, (_e4313 > 0f));
let _e4318 = local_7;
let _e4320 = select(_e4287, 263174i, (263174i < _e4287));
let _e4325 = global_3.member[bitcast<u32>(select(0i, _e4320, (_e4320 > 0i)))];
let _e4326 = bitcast<f32>(_e4325);
let _e4328 = select(_e4287, 263175i, (263175i < _e4287));
let _e4333 = global_3.member[bitcast<u32>(select(0i, _e4328, (_e4328 > 0i)))];
let _e4334 = bitcast<f32>(_e4333);
let _e4336 = select(_e4287, 263176i, (263176i < _e4287));
let _e4341 = global_3.member[bitcast<u32>(select(0i, _e4336, (_e4336 > 0i)))];
let _e4342 = bitcast<f32>(_e4341);
let _e4344 = ((_e4318 - _e4326) * _e4334);
let _e4346 = select(0f, _e4344, (_e4344 > 0f));
let _e4350 = local_7;
let _e4352 = select(_e4287, 263177i, (263177i < _e4287));
let _e4357 = global_3.member[bitcast<u32>(select(0i, _e4352, (_e4352 > 0i)))];
let _e4358 = bitcast<f32>(_e4357);
let _e4360 = select(_e4287, 263178i, (263178i < _e4287));
let _e4365 = global_3.member[bitcast<u32>(select(0i, _e4360, (_e4360 > 0i)))];
let _e4366 = bitcast<f32>(_e4365);
let _e4368 = select(_e4287, 263179i, (263179i < _e4287));
let _e4373 = global_3.member[bitcast<u32>(select(0i, _e4368, (_e4368 > 0i)))];
let _e4374 = bitcast<f32>(_e4373);
let _e4376 = ((_e4350 - _e4358) * _e4366);
let _e4378 = select(0f, _e4376, (_e4376 > 0f));
let _e4381 = local_7;
let _e4383 = select(_e4287, 263180i, (263180i < _e4287));
let _e4388 = global_3.member[bitcast<u32>(select(0i, _e4383, (_e4383 > 0i)))];
let _e4389 = bitcast<f32>(_e4388);
let _e4391 = select(_e4287, 263181i, (263181i < _e4287));
let _e4396 = global_3.member[bitcast<u32>(select(0i, _e4391, (_e4391 > 0i)))];
let _e4397 = bitcast<f32>(_e4396);
let _e4399 = select(_e4287, 263182i, (263182i < _e4287));
let _e4404 = global_3.member[bitcast<u32>(select(0i, _e4399, (_e4399 > 0i)))];
let _e4405 = bitcast<f32>(_e4404);
let _e4407 = ((_e4381 - _e4389) * _e4397);
let _e4409 = select(0f, _e4407, (_e4407 > 0f));
let _e4414 = local_7;
let _e4416 = select(_e4287, 263183i, (263183i < _e4287));
let _e4421 = global_3.member[bitcast<u32>(select(0i, _e4416, (_e4416 > 0i)))];
let _e4422 = bitcast<f32>(_e4421);
let _e4424 = select(_e4287, 263184i, (263184i < _e4287));
let _e4429 = global_3.member[bitcast<u32>(select(0i, _e4424, (_e4424 > 0i)))];
let _e4430 = bitcast<f32>(_e4429);
let _e4432 = select(_e4287, 263185i, (263185i < _e4287));
let _e4437 = global_3.member[bitcast<u32>(select(0i, _e4432, (_e4432 > 0i)))];
let _e4438 = bitcast<f32>(_e4437);
let _e4440 = ((_e4414 - _e4422) * _e4430);
let _e4442 = select(0f, _e4440, (_e4440 > 0f));
let _e4445 = local_7;
let _e4447 = select(_e4287, 263186i, (263186i < _e4287));
let _e4452 = global_3.member[bitcast<u32>(select(0i, _e4447, (_e4447 > 0i)))];
let _e4453 = bitcast<f32>(_e4452);
let _e4455 = select(_e4287, 263187i, (263187i < _e4287));
let _e4460 = global_3.member[bitcast<u32>(select(0i, _e4455, (_e4455 > 0i)))];
let _e4461 = bitcast<f32>(_e4460);
let _e4463 = select(_e4287, 263188i, (263188i < _e4287));
let _e4468 = global_3.member[bitcast<u32>(select(0i, _e4463, (_e4463 > 0i)))];
let _e4469 = bitcast<f32>(_e4468);
let _e4471 = ((_e4445 - _e4453) * _e4461);
let _e4473 = select(0f, _e4471, (_e4471 > 0f));
let _e4477 = local_7;
let _e4479 = select(_e4287, 263189i, (263189i < _e4287));
let _e4484 = global_3.member[bitcast<u32>(select(0i, _e4479, (_e4479 > 0i)))];
let _e4485 = bitcast<f32>(_e4484);
let _e4487 = select(_e4287, 263190i, (263190i < _e4287));
let _e4492 = global_3.member[bitcast<u32>(select(0i, _e4487, (_e4487 > 0i)))];
let _e4493 = bitcast<f32>(_e4492);
let _e4495 = select(_e4287, 263191i, (263191i < _e4287));
let _e4500 = global_3.member[bitcast<u32>(select(0i, _e4495, (_e4495 > 0i)))];
let _e4501 = bitcast<f32>(_e4500);
let _e4503 = ((_e4477 - _e4485) * _e4493);
let _e4505 = select(0f, _e4503, (_e4503 > 0f));
let _e4508 = local_7;
let _e4510 = select(_e4287, 263192i, (263192i < _e4287));
let _e4515 = global_3.member[bitcast<u32>(select(0i, _e4510, (_e4510 > 0i)))];
let _e4516 = bitcast<f32>(_e4515);
let _e4518 = select(_e4287, 263193i, (263193i < _e4287));
let _e4523 = global_3.member[bitcast<u32>(select(0i, _e4518, (_e4518 > 0i)))];
let _e4524 = bitcast<f32>(_e4523);
let _e4526 = select(_e4287, 263194i, (263194i < _e4287));
let _e4531 = global_3.member[bitcast<u32>(select(0i, _e4526, (_e4526 > 0i)))];
let _e4532 = bitcast<f32>(_e4531);
let _e4534 = ((_e4508 - _e4516) * _e4524);
let _e4536 = select(0f, _e4534, (_e4534 > 0f));
let _e4541 = (((select(_e4311, _e4315, (_e4315 < _e4311)) + select(_e4342, _e4346, (_e4346 < _e4342))) + (select(_e4374, _e4378, (_e4378 < _e4374)) + select(_e4405, _e4409, (_e4409 < _e4405)))) + ((select(_e4438, _e4442, (_e4442 < _e4438)) + select(_e4469, _e4473, (_e4473 < _e4469))) + (select(_e4501, _e4505, (_e4505 < _e4501)) + select(_e4532, _e4536, (_e4536 < _e4532)))));
local_6 = _e3573.member;
let _e4542 = local_6;
let _e4544 = ((_e4542 - _e4295) * _e4303);
let _e4546 = select(0f, _e4544, (_e4544 > 0f));
let _e4549 = local_6;
let _e4551 = ((_e4549 - _e4326) * _e4334);
let _e4553 = select(0f, _e4551, (_e4551 > 0f));
let _e4557 = local_6;
let _e4559 = ((_e4557 - _e4358) * _e4366);
let _e4561 = select(0f, _e4559, (_e4559 > 0f));
let _e4564 = local_6;
let _e4566 = ((_e4564 - _e4389) * _e4397);
let _e4568 = select(0f, _e4566, (_e4566 > 0f));
let _e4573 = local_6;
let _e4575 = ((_e4573 - _e4422) * _e4430);
let _e4577 = select(0f, _e4575, (_e4575 > 0f));
let _e4580 = local_6;
let _e4582 = ((_e4580 - _e4453) * _e4461);
let _e4584 = select(0f, _e4582, (_e4582 > 0f));
let _e4588 = local_6;
let _e4590 = ((_e4588 - _e4485) * _e4493);
let _e4592 = select(0f, _e4590, (_e4590 > 0f));
let _e4595 = local_6;
let _e4597 = ((_e4595 - _e4516) * _e4524);
let _e4599 = select(0f, _e4597, (_e4597 > 0f));
let _e4604 = (((select(_e4311, _e4546, (_e4546 < _e4311)) + select(_e4342, _e4553, (_e4553 < _e4342))) + (select(_e4374, _e4561, (_e4561 < _e4374)) + select(_e4405, _e4568, (_e4568 < _e4405)))) + ((select(_e4438, _e4577, (_e4577 < _e4438)) + select(_e4469, _e4584, (_e4584 < _e4469))) + (select(_e4501, _e4592, (_e4592 < _e4501)) + select(_e4532, _e4599, (_e4599 < _e4532)))));
let _e4605 = (255f - 1f);
let _e4607 = select(0f, _e4541, (_e4541 > 0f));
let _e4609 = select(_e4605, _e4607, (_e4607 < _e4605));
let _e4616 = select(0i, select(select(i32(_e4609), i32(-2147483648), (_e4609 < -2147483600f)), 2147483647i, (_e4609 > 2147483500f)), (_e4609 == _e4609));
let _e4620 = (_e4616 - select(0i, 1i, (_e4609 < f32(_e4616))));
let _e4622 = select(0f, _e4604, (_e4604 > 0f));
let _e4624 = select(_e4605, _e4622, (_e4622 < _e4605));
let _e4631 = select(0i, select(select(i32(_e4624), i32(-2147483648), (_e4624 < -2147483600f)), 2147483647i, (_e4624 > 2147483500f)), (_e4624 == _e4624));
let _e4635 = (_e4631 - select(0i, 1i, (_e4624 < f32(_e4631))));
let _e4637 = select(_e4287, 263195i, (263195i < _e4287));
let _e4643 = global_3.member[bitcast<u32>(select(0i, _e4637, (_e4637 > 0i)))];
let _e4644 = bitcast<f32>(_e4643);
let _e4646 = select(_e4287, 263196i, (263196i < _e4287));
let _e4652 = global_3.member[bitcast<u32>(select(0i, _e4646, (_e4646 > 0i)))];
let _e4653 = bitcast<f32>(_e4652);
let _e4654 = (_e3573.member - _e3956);
let _e4660 = (1f / select(_e4654, 1f, (bitcast<f32>((bitcast<u32>(_e4654) & 2147483647u)) < 1e-20f)));
let _e4666 = ((select(_e4644, _e3573.member, (_e3573.member < _e4644)) - select(_e4644, _e3956, (_e3956 < _e4644))) * _e4660);
let _e4672 = ((select(_e4653, _e3573.member, (_e3573.member > _e4653)) - select(_e4653, _e3956, (_e3956 > _e4653))) * _e4660);
let _e4675 = (((_e4620 * 256i) + _e4635) * 4i);
let _e4679 = (_e4604 - f32(_e4635));
let _e4683 = select(_e4287, _e4675, (_e4675 < _e4287));
let _e4689 = global_3.member[bitcast<u32>(select(0i, _e4683, (_e4683 > 0i)))];
let _e4690 = (_e4675 + 4i);
let _e4692 = select(_e4287, _e4690, (_e4690 < _e4287));
let _e4698 = global_3.member[bitcast<u32>(select(0i, _e4692, (_e4692 > 0i)))];
let _e4699 = (_e4675 + 1024i);
let _e4701 = select(_e4287, _e4699, (_e4699 < _e4287));
let _e4707 = global_3.member[bitcast<u32>(select(0i, _e4701, (_e4701 > 0i)))];
let _e4708 = (_e4675 + 1028i);
let _e4710 = select(_e4287, _e4708, (_e4708 < _e4287));
let _e4716 = global_3.member[bitcast<u32>(select(0i, _e4710, (_e4710 > 0i)))];
let _e4718 = select(_e4287, 0i, (0i < _e4287));
let _e4724 = global_3.member[bitcast<u32>(select(0i, _e4718, (_e4718 > 0i)))];
let _e4726 = select(_e4287, 262140i, (262140i < _e4287));
let _e4732 = global_3.member[bitcast<u32>(select(0i, _e4726, (_e4726 > 0i)))];
let _e4737 = (bitcast<f32>(((_e4689 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4745 = (_e4737 + (((bitcast<f32>(((_e4698 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4737) * _e4679));
let _e4750 = (bitcast<f32>(((_e4707 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4776 = (((_e4745 + (((_e4750 + (((bitcast<f32>(((_e4716 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4750) * _e4679)) - _e4745) * (_e4541 - f32(_e4620)))) * (1f - (_e4666 + _e4672))) + (((bitcast<f32>(((_e4724 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4666) + ((bitcast<f32>(((_e4732 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4672)));
let _e4780 = -((_e4776 * (_e4279 * _e4164.member)));
let _e4782 = select(-87f, _e4780, (_e4780 > -87f));
let _e4784 = select(88f, _e4782, (_e4782 < 88f));
let _e4786 = ((_e4784 * 1.442695f) + 0.5f);
let _e4788 = select(-127f, _e4786, (_e4786 > -127f));
let _e4790 = select(128f, _e4788, (_e4788 < 128f));
let _e4797 = select(0i, select(select(i32(_e4790), i32(-2147483648), (_e4790 < -2147483600f)), 2147483647i, (_e4790 > 2147483500f)), (_e4790 == _e4790));
let _e4801 = (_e4797 - select(0i, 1i, (_e4790 < f32(_e4797))));
let _e4802 = f32(_e4801);
let _e4806 = ((_e4784 - (_e4802 * 0.6933594f)) - (_e4802 * -2.1219444e-4f));
let _e4826 = ((1f + (_e4806 * (1f + (_e4806 * (0.5f + (_e4806 * (0.16666667f + (_e4806 * (0.041666668f + (_e4806 * (0.008333334f + (_e4806 * (0.001388889f + (_e4806 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4801 + 127i)) << bitcast<u32>(23i))));
let _e4827 = (1f - _e4826);
phi_12682_ = type_35(_e4826, _e4827, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e4827 / select(1e-12f, _e4776, (_e4776 > 1e-12f))))));
} else {
local_5 = _e3956;
let _e4835 = local_5;
let _e4837 = (bitcast<i32>(_e166) - 1i);
let _e4839 = select(_e4837, 263171i, (263171i < _e4837));
let _e4844 = global_3.member[bitcast<u32>(select(0i, _e4839, (_e4839 > 0i)))];
let _e4845 = bitcast<f32>(_e4844);
let _e4847 = select(_e4837, 263172i, (263172i < _e4837));
let _e4852 = global_3.member[bitcast<u32>(select(0i, _e4847, (_e4847 > 0i)))];
let _e4853 = bitcast<f32>(_e4852);
let _e4855 = select(_e4837, 263173i, (263173i < _e4837));
let _e4860 = global_3.member[bitcast<u32>(select(0i, _e4855, (_e4855 > 0i)))];
let _e4861 = bitcast<f32>(_e4860);
let _e4863 = ((_e4835 - _e4845) * _e4853);
let _e4865 = select(0f, _e4863, (_e4863 > 0f));
let _e4868 = local_5;
let _e4870 = select(_e4837, 263174i, (263174i < _e4837));
let _e4875 = global_3.member[bitcast<u32>(select(0i, _e4870, (_e4870 > 0i)))];
let _e4876 = bitcast<f32>(_e4875);
let _e4878 = select(_e4837, 263175i, (263175i < _e4837));
let _e4883 = global_3.member[bitcast<u32>(select(0i, _e4878, (_e4878 > 0i)))];
let _e4884 = bitcast<f32>(_e4883);
let _e4886 = select(_e4837, 263176i, (263176i < _e4837));
let _e4891 = global_3.member[bitcast<u32>(select(0i, _e4886, (_e4886 > 0i)))];
let _e4892 = bitcast<f32>(_e4891);
let _e4894 = ((_e4868 - _e4876) * _e4884);
let _e4896 = select(0f, _e4894, (_e4894 > 0f));
let _e4900 = local_5;
let _e4902 = select(_e4837, 263177i, (263177i < _e4837));
let _e4907 = global_3.member[bitcast<u32>(select(0i, _e4902, (_e4902 > 0i)))];
let _e4908 = bitcast<f32>(_e4907);
let _e4910 = select(_e4837, 263178i, (263178i < _e4837));
let _e4915 = global_3.member[bitcast<u32>(select(0i, _e4910, (_e4910 > 0i)))];
let _e4916 = bitcast<f32>(_e4915);
let _e4918 = select(_e4837, 263179i, (263179i < _e4837));
let _e4923 = global_3.member[bitcast<u32>(select(0i, _e4918, (_e4918 > 0i)))];
let _e4924 = bitcast<f32>(_e4923);
let _e4926 = ((_e4900 - _e4908) * _e4916);
let _e4928 = select(0f, _e4926, (_e4926 > 0f));
let _e4931 = local_5;
let _e4933 = select(_e4837, 263180i, (263180i < _e4837));
let _e4938 = global_3.member[bitcast<u32>(select(0i, _e4933, (_e4933 > 0i)))];
let _e4939 = bitcast<f32>(_e4938);
let _e4941 = select(_e4837, 263181i, (263181i < _e4837));
let _e4946 = global_3.member[bitcast<u32>(select(0i, _e4941, (_e4941 > 0i)))];
let _e4947 = bitcast<f32>(_e4946);
let _e4949 = select(_e4837, 263182i, (263182i < _e4837));
let _e4954 = global_3.member[bitcast<u32>(select(0i, _e4949, (_e4949 > 0i)))];
let _e4955 = bitcast<f32>(_e4954);
let _e4957 = ((_e4931 - _e4939) * _e4947);
let _e4959 = select(0f, _e4957, (_e4957 > 0f));
let _e4964 = local_5;
let _e4966 = select(_e4837, 263183i, (263183i < _e4837));
let _e4971 = global_3.member[bitcast<u32>(select(0i, _e4966, (_e4966 > 0i)))];
let _e4972 = bitcast<f32>(_e4971);
let _e4974 = select(_e4837, 263184i, (263184i < _e4837));
let _e4979 = global_3.member[bitcast<u32>(select(0i, _e4974, (_e4974 > 0i)))];
let _e4980 = bitcast<f32>(_e4979);
let _e4982 = select(_e4837, 263185i, (263185i < _e4837));
let _e4987 = global_3.member[bitcast<u32>(select(0i, _e4982, (_e4982 > 0i)))];
let _e4988 = bitcast<f32>(_e4987);
let _e4990 = ((_e4964 - _e4972) * _e4980);
let _e4992 = select(0f, _e4990, (_e4990 > 0f));
let _e4995 = local_5;
let _e4997 = select(_e4837, 263186i, (263186i < _e4837));
let _e5002 = global_3.member[bitcast<u32>(select(0i, _e4997, (_e4997 > 0i)))];
let _e5003 = bitcast<f32>(_e5002);
let _e5005 = select(_e4837, 263187i, (263187i < _e4837));
let _e5010 = global_3.member[bitcast<u32>(select(0i, _e5005, (_e5005 > 0i)))];
let _e5011 = bitcast<f32>(_e5010);
let _e5013 = select(_e4837, 263188i, (263188i < _e4837));
let _e5018 = global_3.member[bitcast<u32>(select(0i, _e5013, (_e5013 > 0i)))];
let _e5019 = bitcast<f32>(_e5018);
let _e5021 = ((_e4995 - _e5003) * _e5011);
let _e5023 = select(0f, _e5021, (_e5021 > 0f));
let _e5027 = local_5;
let _e5029 = select(_e4837, 263189i, (263189i < _e4837));
let _e5034 = global_3.member[bitcast<u32>(select(0i, _e5029, (_e5029 > 0i)))];
let _e5035 = bitcast<f32>(_e5034);
let _e5037 = select(_e4837, 263190i, (263190i < _e4837));
let _e5042 = global_3.member[bitcast<u32>(select(0i, _e5037, (_e5037 > 0i)))];
let _e5043 = bitcast<f32>(_e5042);
let _e5045 = select(_e4837, 263191i, (263191i < _e4837));
let _e5050 = global_3.member[bitcast<u32>(select(0i, _e5045, (_e5045 > 0i)))];
let _e5051 = bitcast<f32>(_e5050);
let _e5053 = ((_e5027 - _e5035) * _e5043);
let _e5055 = select(0f, _e5053, (_e5053 > 0f));
let _e5058 = local_5;
let _e5060 = select(_e4837, 263192i, (263192i < _e4837));
let _e5065 = global_3.member[bitcast<u32>(select(0i, _e5060, (_e5060 > 0i)))];
let _e5066 = bitcast<f32>(_e5065);
let _e5068 = select(_e4837, 263193i, (263193i < _e4837));
let _e5073 = global_3.member[bitcast<u32>(select(0i, _e5068, (_e5068 > 0i)))];
let _e5074 = bitcast<f32>(_e5073);
let _e5076 = select(_e4837, 263194i, (263194i < _e4837));
let _e5081 = global_3.member[bitcast<u32>(select(0i, _e5076, (_e5076 > 0i)))];
let _e5082 = bitcast<f32>(_e5081);
let _e5084 = ((_e5058 - _e5066) * _e5074);
let _e5086 = select(0f, _e5084, (_e5084 > 0f));
let _e5091 = (((select(_e4861, _e4865, (_e4865 < _e4861)) + select(_e4892, _e4896, (_e4896 < _e4892))) + (select(_e4924, _e4928, (_e4928 < _e4924)) + select(_e4955, _e4959, (_e4959 < _e4955)))) + ((select(_e4988, _e4992, (_e4992 < _e4988)) + select(_e5019, _e5023, (_e5023 < _e5019))) + (select(_e5051, _e5055, (_e5055 < _e5051)) + select(_e5082, _e5086, (_e5086 < _e5082)))));
local_4 = _e3573.member;
let _e5092 = local_4;
let _e5094 = ((_e5092 - _e4845) * _e4853);
let _e5096 = select(0f, _e5094, (_e5094 > 0f));
let _e5099 = local_4;
let _e5101 = ((_e5099 - _e4876) * _e4884);
let _e5103 = select(0f, _e5101, (_e5101 > 0f));
let _e5107 = local_4;
let _e5109 = ((_e5107 - _e4908) * _e4916);
let _e5111 = select(0f, _e5109, (_e5109 > 0f));
let _e5114 = local_4;
let _e5116 = ((_e5114 - _e4939) * _e4947);
let _e5118 = select(0f, _e5116, (_e5116 > 0f));
let _e5123 = local_4;
let _e5125 = ((_e5123 - _e4972) * _e4980);
let _e5127 = select(0f, _e5125, (_e5125 > 0f));
let _e5130 = local_4;
let _e5132 = ((_e5130 - _e5003) * _e5011);
let _e5134 = select(0f, _e5132, (_e5132 > 0f));
let _e5138 = local_4;
let _e5140 = ((_e5138 - _e5035) * _e5043);
let _e5142 = select(0f, _e5140, (_e5140 > 0f));
let _e5145 = local_4;
let _e5147 = ((_e5145 - _e5066) * _e5074);
let _e5149 = select(0f, _e5147, (_e5147 > 0f));
let _e5154 = (((select(_e4861, _e5096, (_e5096 < _e4861)) + select(_e4892, _e5103, (_e5103 < _e4892))) + (select(_e4924, _e5111, (_e5111 < _e4924)) + select(_e4955, _e5118, (_e5118 < _e4955)))) + ((select(_e4988, _e5127, (_e5127 < _e4988)) + select(_e5019, _e5134, (_e5134 < _e5019))) + (select(_e5051, _e5142, (_e5142 < _e5051)) + select(_e5082, _e5149, (_e5149 < _e5082)))));
let _e5155 = (255f - 1f);
let _e5157 = select(0f, _e5091, (_e5091 > 0f));
let _e5159 = select(_e5155, _e5157, (_e5157 < _e5155));
let _e5166 = select(0i, select(select(i32(_e5159), i32(-2147483648), (_e5159 < -2147483600f)), 2147483647i, (_e5159 > 2147483500f)), (_e5159 == _e5159));
let _e5170 = (_e5166 - select(0i, 1i, (_e5159 < f32(_e5166))));
let _e5172 = select(0f, _e5154, (_e5154 > 0f));
let _e5174 = select(_e5155, _e5172, (_e5172 < _e5155));
let _e5181 = select(0i, select(select(i32(_e5174), i32(-2147483648), (_e5174 < -2147483600f)), 2147483647i, (_e5174 > 2147483500f)), (_e5174 == _e5174));
let _e5185 = (_e5181 - select(0i, 1i, (_e5174 < f32(_e5181))));
let _e5187 = select(_e4837, 263195i, (263195i < _e4837));
let _e5193 = global_3.member[bitcast<u32>(select(0i, _e5187, (_e5187 > 0i)))];
let _e5194 = bitcast<f32>(_e5193);
let _e5196 = select(_e4837, 263196i, (263196i < _e4837));
let _e5202 = global_3.member[bitcast<u32>(select(0i, _e5196, (_e5196 > 0i)))];
let _e5203 = bitcast<f32>(_e5202);
let _e5204 = (_e3573.member - _e3956);
let _e5210 = (1f / select(_e5204, 1f, (bitcast<f32>((bitcast<u32>(_e5204) & 2147483647u)) < 1e-20f)));
let _e5216 = ((select(_e5194, _e3573.member, (_e3573.member < _e5194)) - select(_e5194, _e3956, (_e3956 < _e5194))) * _e5210);
let _e5222 = ((select(_e5203, _e3573.member, (_e3573.member > _e5203)) - select(_e5203, _e3956, (_e3956 > _e5203))) * _e5210);
let _e5225 = (((_e5170 * 256i) + _e5185) * 4i);
let _e5227 = (_e5091 - f32(_e5170));
let _e5229 = (_e5154 - f32(_e5185));
let _e5231 = (1f - (_e5216 + _e5222));
let _e5233 = select(_e4837, _e5225, (_e5225 < _e4837));
let _e5239 = global_3.member[bitcast<u32>(select(0i, _e5233, (_e5233 > 0i)))];
let _e5240 = (_e5225 + 4i);
let _e5242 = select(_e4837, _e5240, (_e5240 < _e4837));
let _e5248 = global_3.member[bitcast<u32>(select(0i, _e5242, (_e5242 > 0i)))];
let _e5249 = (_e5225 + 1024i);
let _e5251 = select(_e4837, _e5249, (_e5249 < _e4837));
let _e5257 = global_3.member[bitcast<u32>(select(0i, _e5251, (_e5251 > 0i)))];
let _e5258 = (_e5225 + 1028i);
let _e5260 = select(_e4837, _e5258, (_e5258 < _e4837));
let _e5266 = global_3.member[bitcast<u32>(select(0i, _e5260, (_e5260 > 0i)))];
let _e5268 = select(_e4837, 0i, (0i < _e4837));
let _e5274 = global_3.member[bitcast<u32>(select(0i, _e5268, (_e5268 > 0i)))];
let _e5276 = select(_e4837, 262140i, (262140i < _e4837));
let _e5282 = global_3.member[bitcast<u32>(select(0i, _e5276, (_e5276 > 0i)))];
let _e5287 = (bitcast<f32>(((_e5239 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5295 = (_e5287 + (((bitcast<f32>(((_e5248 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5287) * _e5229));
let _e5300 = (bitcast<f32>(((_e5257 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5326 = (((_e5295 + (((_e5300 + (((bitcast<f32>(((_e5266 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5300) * _e5229)) - _e5295) * _e5227)) * _e5231) + (((bitcast<f32>(((_e5274 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5216) + ((bitcast<f32>(((_e5282 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5222)));
let _e5343 = (bitcast<f32>((((_e5239 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5351 = (_e5343 + (((bitcast<f32>((((_e5248 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5343) * _e5229));
let _e5356 = (bitcast<f32>((((_e5257 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5383 = (_e5225 + 1i);
let _e5385 = select(_e4837, _e5383, (_e5383 < _e4837));
let _e5391 = global_3.member[bitcast<u32>(select(0i, _e5385, (_e5385 > 0i)))];
let _e5392 = (_e5225 + 5i);
let _e5394 = select(_e4837, _e5392, (_e5392 < _e4837));
let _e5400 = global_3.member[bitcast<u32>(select(0i, _e5394, (_e5394 > 0i)))];
let _e5401 = (_e5225 + 1025i);
let _e5403 = select(_e4837, _e5401, (_e5401 < _e4837));
let _e5409 = global_3.member[bitcast<u32>(select(0i, _e5403, (_e5403 > 0i)))];
let _e5410 = (_e5225 + 1029i);
let _e5412 = select(_e4837, _e5410, (_e5410 < _e4837));
let _e5418 = global_3.member[bitcast<u32>(select(0i, _e5412, (_e5412 > 0i)))];
let _e5420 = select(_e4837, 1i, (1i < _e4837));
let _e5426 = global_3.member[bitcast<u32>(select(0i, _e5420, (_e5420 > 0i)))];
let _e5428 = select(_e4837, 262141i, (262141i < _e4837));
let _e5434 = global_3.member[bitcast<u32>(select(0i, _e5428, (_e5428 > 0i)))];
let _e5439 = (bitcast<f32>(((_e5391 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5447 = (_e5439 + (((bitcast<f32>(((_e5400 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5439) * _e5229));
let _e5452 = (bitcast<f32>(((_e5409 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5495 = (bitcast<f32>((((_e5391 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5503 = (_e5495 + (((bitcast<f32>((((_e5400 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5495) * _e5229));
let _e5508 = (bitcast<f32>((((_e5409 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5538 = (_e4279 * _e4164.member_1);
let _e5540 = -(((((_e5351 + (((_e5356 + (((bitcast<f32>((((_e5266 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5356) * _e5229)) - _e5351) * _e5227)) * _e5231) + (((bitcast<f32>((((_e5274 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5216) + ((bitcast<f32>((((_e5282 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5222))) * _e5538));
let _e5542 = select(-87f, _e5540, (_e5540 > -87f));
let _e5544 = select(88f, _e5542, (_e5542 < 88f));
let _e5546 = ((_e5544 * 1.442695f) + 0.5f);
let _e5548 = select(-127f, _e5546, (_e5546 > -127f));
let _e5550 = select(128f, _e5548, (_e5548 < 128f));
let _e5557 = select(0i, select(select(i32(_e5550), i32(-2147483648), (_e5550 < -2147483600f)), 2147483647i, (_e5550 > 2147483500f)), (_e5550 == _e5550));
let _e5561 = (_e5557 - select(0i, 1i, (_e5550 < f32(_e5557))));
let _e5562 = f32(_e5561);
let _e5566 = ((_e5544 - (_e5562 * 0.6933594f)) - (_e5562 * -2.1219444e-4f));
let _e5588 = -(((((_e5447 + (((_e5452 + (((bitcast<f32>(((_e5418 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5452) * _e5229)) - _e5447) * _e5227)) * _e5231) + (((bitcast<f32>(((_e5426 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5216) + ((bitcast<f32>(((_e5434 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5222))) * _e5538));
let _e5590 = select(-87f, _e5588, (_e5588 > -87f));
let _e5592 = select(88f, _e5590, (_e5590 < 88f));
let _e5594 = ((_e5592 * 1.442695f) + 0.5f);
let _e5596 = select(-127f, _e5594, (_e5594 > -127f));
let _e5598 = select(128f, _e5596, (_e5596 < 128f));
let _e5605 = select(0i, select(select(i32(_e5598), i32(-2147483648), (_e5598 < -2147483600f)), 2147483647i, (_e5598 > 2147483500f)), (_e5598 == _e5598));
let _e5609 = (_e5605 - select(0i, 1i, (_e5598 < f32(_e5605))));
let _e5610 = f32(_e5609);
let _e5614 = ((_e5592 - (_e5610 * 0.6933594f)) - (_e5610 * -2.1219444e-4f));
let _e5636 = -(((((_e5503 + (((_e5508 + (((bitcast<f32>((((_e5418 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5508) * _e5229)) - _e5503) * _e5227)) * _e5231) + (((bitcast<f32>((((_e5426 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5216) + ((bitcast<f32>((((_e5434 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5222))) * _e5538));
let _e5638 = select(-87f, _e5636, (_e5636 > -87f));
let _e5640 = select(88f, _e5638, (_e5638 < 88f));
let _e5642 = ((_e5640 * 1.442695f) + 0.5f);
let _e5644 = select(-127f, _e5642, (_e5642 > -127f));
let _e5646 = select(128f, _e5644, (_e5644 < 128f));
let _e5653 = select(0i, select(select(i32(_e5646), i32(-2147483648), (_e5646 < -2147483600f)), 2147483647i, (_e5646 > 2147483500f)), (_e5646 == _e5646));
let _e5657 = (_e5653 - select(0i, 1i, (_e5646 < f32(_e5653))));
let _e5658 = f32(_e5657);
let _e5662 = ((_e5640 - (_e5658 * 0.6933594f)) - (_e5658 * -2.1219444e-4f));
let _e5685 = -((_e5326 * (_e4279 * _e4164.member)));
let _e5687 = select(-87f, _e5685, (_e5685 > -87f));
let _e5689 = select(88f, _e5687, (_e5687 < 88f));
let _e5691 = ((_e5689 * 1.442695f) + 0.5f);
let _e5693 = select(-127f, _e5691, (_e5691 > -127f));
let _e5695 = select(128f, _e5693, (_e5693 < 128f));
let _e5702 = select(0i, select(select(i32(_e5695), i32(-2147483648), (_e5695 < -2147483600f)), 2147483647i, (_e5695 > 2147483500f)), (_e5695 == _e5695));
let _e5706 = (_e5702 - select(0i, 1i, (_e5695 < f32(_e5702))));
let _e5707 = f32(_e5706);
let _e5711 = ((_e5689 - (_e5707 * 0.6933594f)) - (_e5707 * -2.1219444e-4f));
let _e5731 = ((1f + (_e5711 * (1f + (_e5711 * (0.5f + (_e5711 * (0.16666667f + (_e5711 * (0.041666668f + (_e5711 * (0.008333334f + (_e5711 * (0.001388889f + (_e5711 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5706 + 127i)) << bitcast<u32>(23i))));
let _e5732 = (1f - _e5731);
phi_12682_ = type_35(_e5731, _e5732, vec3<f32>(((1f + (_e5566 * (1f + (_e5566 * (0.5f + (_e5566 * (0.16666667f + (_e5566 * (0.041666668f + (_e5566 * (0.008333334f + (_e5566 * (0.001388889f + (_e5566 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5561 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5614 * (1f + (_e5614 * (0.5f + (_e5614 * (0.16666667f + (_e5614 * (0.041666668f + (_e5614 * (0.008333334f + (_e5614 * (0.001388889f + (_e5614 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5609 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5662 * (1f + (_e5662 * (0.5f + (_e5662 * (0.16666667f + (_e5662 * (0.041666668f + (_e5662 * (0.008333334f + (_e5662 * (0.001388889f + (_e5662 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5657 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e5732 / select(1e-12f, _e5326, (_e5326 > 1e-12f))))));
}
let _e5740 = phi_12682_;
if _e1230 {
let _e5745 = global_1.member.member_8.member.member;
let _e5753 = global_1.member.member_8.member_1.member;
let _e5761 = global_1.member.member_8.member_2.member;
let _e5765 = (-0.5f - _e1209);
let _e5766 = -(_e4172);
let _e5769 = (_e4172 - _e5765);
let _e5770 = (_e5765 - _e4172);
let _e5772 = select(_e5770, _e5769, (_e5769 > _e5770));
let _e5775 = (select(_e5766, _e4172, (_e4172 > _e5766)) / select(1e-30f, _e5772, (_e5772 > 1e-30f)));
let _e5777 = (_e5765 < 0f);
let _e5779 = select(0f, select(2f, _e5775, _e5777), (_e4172 > 0f));
let _e5780 = (_e5765 > 0f);
let _e5783 = select(2f, select(0f, _e5775, (_e4172 < 0f)), _e5780);
let _e5784 = (_e4172 > -1e30f);
let _e5788 = ((_e5779 > -1f) || ((_e5779 == -1f) && _e5784));
let _e5789 = (_e5783 < 2f);
let _e5790 = select(-1f, _e5779, _e5788);
let _e5794 = select(2f, _e5783, _e5789);
let _e5798 = select(-1e30f, _e4172, _e5784);
let _e5799 = (_e5765 > -1e30f);
let _e5800 = select(-1e30f, _e5765, _e5799);
let _e5804 = (_e1173 - _e3579);
let _e5805 = (_e1209 - _e3579);
let _e5806 = -(_e5804);
let _e5809 = (_e5804 - _e5805);
let _e5810 = (_e5805 - _e5804);
let _e5812 = select(_e5810, _e5809, (_e5809 > _e5810));
let _e5815 = (select(_e5806, _e5804, (_e5804 > _e5806)) / select(1e-30f, _e5812, (_e5812 > 1e-30f)));
let _e5817 = (_e5805 < 0f);
let _e5819 = select(0f, select(2f, _e5815, _e5817), (_e5804 > 0f));
let _e5820 = (_e5805 > 0f);
let _e5823 = select(2f, select(0f, _e5815, (_e5804 < 0f)), _e5820);
let _e5824 = (_e5804 > _e5798);
let _e5828 = ((_e5819 > _e5790) || ((_e5819 == _e5790) && _e5824));
let _e5829 = (_e5823 < _e5794);
let _e5830 = select(_e5790, _e5819, _e5828);
let _e5834 = select(_e5794, _e5823, _e5829);
let _e5838 = select(_e5798, _e5804, _e5824);
let _e5839 = (_e5805 > _e5800);
let _e5840 = select(_e5800, _e5805, _e5839);
let _e5844 = (-0.5f - _e1215);
let _e5845 = -(_e4201);
let _e5848 = (_e4201 - _e5844);
let _e5849 = (_e5844 - _e4201);
let _e5851 = select(_e5849, _e5848, (_e5848 > _e5849));
let _e5854 = (select(_e5845, _e4201, (_e4201 > _e5845)) / select(1e-30f, _e5851, (_e5851 > 1e-30f)));
let _e5856 = (_e5844 < 0f);
let _e5858 = select(0f, select(2f, _e5854, _e5856), (_e4201 > 0f));
let _e5859 = (_e5844 > 0f);
let _e5862 = select(2f, select(0f, _e5854, (_e4201 < 0f)), _e5859);
let _e5863 = (_e4201 > _e5838);
let _e5867 = ((_e5858 > _e5830) || ((_e5858 == _e5830) && _e5863));
let _e5868 = (_e5862 < _e5834);
let _e5869 = select(_e5830, _e5858, _e5867);
let _e5873 = select(_e5834, _e5862, _e5868);
let _e5877 = select(_e5838, _e4201, _e5863);
let _e5878 = (_e5844 > _e5840);
let _e5879 = select(_e5840, _e5844, _e5878);
let _e5883 = (_e1188 - _e3589);
let _e5884 = (_e1215 - _e3589);
let _e5885 = -(_e5883);
let _e5888 = (_e5883 - _e5884);
let _e5889 = (_e5884 - _e5883);
let _e5891 = select(_e5889, _e5888, (_e5888 > _e5889));
let _e5894 = (select(_e5885, _e5883, (_e5883 > _e5885)) / select(1e-30f, _e5891, (_e5891 > 1e-30f)));
let _e5896 = (_e5884 < 0f);
let _e5898 = select(0f, select(2f, _e5894, _e5896), (_e5883 > 0f));
let _e5899 = (_e5884 > 0f);
let _e5902 = select(2f, select(0f, _e5894, (_e5883 < 0f)), _e5899);
let _e5903 = (_e5883 > _e5877);
let _e5907 = ((_e5898 > _e5869) || ((_e5898 == _e5869) && _e5903));
let _e5908 = (_e5902 < _e5873);
let _e5909 = select(_e5869, _e5898, _e5907);
let _e5913 = select(_e5873, _e5902, _e5908);
let _e5917 = select(_e5877, _e5883, _e5903);
let _e5918 = (_e5884 > _e5879);
let _e5919 = select(_e5879, _e5884, _e5918);
let _e5923 = (-0.5f - _e1221);
let _e5924 = -(_e4230);
let _e5927 = (_e4230 - _e5923);
let _e5928 = (_e5923 - _e4230);
let _e5930 = select(_e5928, _e5927, (_e5927 > _e5928));
let _e5933 = (select(_e5924, _e4230, (_e4230 > _e5924)) / select(1e-30f, _e5930, (_e5930 > 1e-30f)));
let _e5935 = (_e5923 < 0f);
let _e5937 = select(0f, select(2f, _e5933, _e5935), (_e4230 > 0f));
let _e5938 = (_e5923 > 0f);
let _e5941 = select(2f, select(0f, _e5933, (_e4230 < 0f)), _e5938);
let _e5942 = (_e4230 > _e5917);
let _e5946 = ((_e5937 > _e5909) || ((_e5937 == _e5909) && _e5942));
let _e5947 = (_e5941 < _e5913);
let _e5948 = select(_e5909, _e5937, _e5946);
let _e5952 = select(_e5913, _e5941, _e5947);
let _e5956 = select(_e5917, _e4230, _e5942);
let _e5957 = (_e5923 > _e5919);
let _e5958 = select(_e5919, _e5923, _e5957);
let _e5962 = (_e1203 - _e3599);
let _e5963 = (_e1221 - _e3599);
let _e5964 = -(_e5962);
let _e5967 = (_e5962 - _e5963);
let _e5968 = (_e5963 - _e5962);
let _e5970 = select(_e5968, _e5967, (_e5967 > _e5968));
let _e5973 = (select(_e5964, _e5962, (_e5962 > _e5964)) / select(1e-30f, _e5970, (_e5970 > 1e-30f)));
let _e5975 = (_e5963 < 0f);
let _e5977 = select(0f, select(2f, _e5973, _e5975), (_e5962 > 0f));
let _e5978 = (_e5963 > 0f);
let _e5981 = select(2f, select(0f, _e5973, (_e5962 < 0f)), _e5978);
let _e5982 = (_e5962 > _e5956);
let _e5986 = ((_e5977 > _e5948) || ((_e5977 == _e5948) && _e5982));
let _e5987 = (_e5981 < _e5952);
let _e5988 = select(_e5948, _e5977, _e5986);
let _e5989 = select(select(select(select(select(select(0f, _e5745.member, _e5788), _e5745.member, _e5828), _e5753.member, _e5867), _e5753.member, _e5907), _e5761.member, _e5946), _e5761.member, _e5986);
let _e5990 = select(select(select(select(select(select(0f, _e5745.member_1, _e5788), _e5745.member_1, _e5828), _e5753.member_1, _e5867), _e5753.member_1, _e5907), _e5761.member_1, _e5946), _e5761.member_1, _e5986);
let _e5991 = select(select(select(select(select(select(1f, _e5745.member_2, _e5788), _e5745.member_2, _e5828), _e5753.member_2, _e5867), _e5753.member_2, _e5907), _e5761.member_2, _e5946), _e5761.member_2, _e5986);
let _e5993 = select(_e5952, _e5981, _e5987);
let _e5994 = select(select(select(select(select(select(0f, _e5745.member, _e5789), _e5745.member, _e5829), _e5753.member, _e5868), _e5753.member, _e5908), _e5761.member, _e5947), _e5761.member, _e5987);
let _e5995 = select(select(select(select(select(select(0f, _e5745.member_1, _e5789), _e5745.member_1, _e5829), _e5753.member_1, _e5868), _e5753.member_1, _e5908), _e5761.member_1, _e5947), _e5761.member_1, _e5987);
let _e5996 = select(select(select(select(select(select(1f, _e5745.member_2, _e5789), _e5745.member_2, _e5829), _e5753.member_2, _e5868), _e5753.member_2, _e5908), _e5761.member_2, _e5947), _e5761.member_2, _e5987);
let _e5998 = select(_e5956, _e5962, _e5982);
let _e5999 = (_e5963 > _e5958);
let _e6000 = select(_e5958, _e5963, _e5999);
let _e6001 = select(select(select(select(select(select(0f, _e5745.member, _e5784), _e5745.member, _e5824), _e5753.member, _e5863), _e5753.member, _e5903), _e5761.member, _e5942), _e5761.member, _e5982);
let _e6002 = select(select(select(select(select(select(0f, _e5745.member_1, _e5784), _e5745.member_1, _e5824), _e5753.member_1, _e5863), _e5753.member_1, _e5903), _e5761.member_1, _e5942), _e5761.member_1, _e5982);
let _e6003 = select(select(select(select(select(select(1f, _e5745.member_2, _e5784), _e5745.member_2, _e5824), _e5753.member_2, _e5863), _e5753.member_2, _e5903), _e5761.member_2, _e5942), _e5761.member_2, _e5982);
if _e3961 {
phi_14001_ = type_34(_e5988, vec3<f32>(_e5989, _e5990, _e5991), _e5993, vec3<f32>(_e5994, _e5995, _e5996), _e5998, _e6000, vec3<f32>(_e6001, _e6002, _e6003));
} else {
let _e6010 = (((_e5745.member * _e5745.member) + (_e5745.member_1 * _e5745.member_1)) + (_e5745.member_2 * _e5745.member_2));
let _e6013 = sqrt(select(0f, _e6010, (_e6010 > 0f)));
let _e6017 = global_1.member.member_16.member_1;
let _e6018 = (_e6017 != 0u);
let _e6022 = global_1.member.member_16.member;
let _e6042 = select(-1e6f, (((((_e6022.member.member * _e1130) + (_e6022.member.member_1 * _e1143)) + (_e6022.member.member_2 * _e1108)) + _e6022.member_1) * _e6013), _e6018);
let _e6043 = select(-1e6f, (((((_e6022.member.member * _e1153) + (_e6022.member.member_1 * _e1158)) + (_e6022.member.member_2 * _e1147)) + _e6022.member_1) * _e6013), _e6018);
let _e6048 = global_1.member.member_16.member.member;
let _e6052 = -(_e6042);
let _e6055 = (_e6042 - _e6043);
let _e6056 = (_e6043 - _e6042);
let _e6058 = select(_e6056, _e6055, (_e6055 > _e6056));
let _e6061 = (select(_e6052, _e6042, (_e6042 > _e6052)) / select(1e-30f, _e6058, (_e6058 > 1e-30f)));
let _e6065 = select(0f, select(2f, _e6061, (_e6043 < 0f)), (_e6042 > 0f));
let _e6069 = select(2f, select(0f, _e6061, (_e6042 < 0f)), (_e6043 > 0f));
let _e6070 = (_e6042 > _e5998);
let _e6074 = ((_e6065 > _e5988) || ((_e6065 == _e5988) && _e6070));
let _e6075 = (_e6069 < _e5993);
let _e6076 = select(_e5988, _e6065, _e6074);
let _e6080 = select(_e5993, _e6069, _e6075);
let _e6084 = select(_e5998, _e6042, _e6070);
let _e6086 = select(_e6000, _e6043, (_e6043 > _e6000));
let _e6093 = global_1.member.member_17.member_1;
let _e6094 = (_e6093 != 0u);
let _e6098 = global_1.member.member_17.member;
let _e6118 = select(-1e6f, (((((_e6098.member.member * _e1130) + (_e6098.member.member_1 * _e1143)) + (_e6098.member.member_2 * _e1108)) + _e6098.member_1) * _e6013), _e6094);
let _e6119 = select(-1e6f, (((((_e6098.member.member * _e1153) + (_e6098.member.member_1 * _e1158)) + (_e6098.member.member_2 * _e1147)) + _e6098.member_1) * _e6013), _e6094);
let _e6124 = global_1.member.member_17.member.member;
let _e6128 = -(_e6118);
let _e6131 = (_e6118 - _e6119);
let _e6132 = (_e6119 - _e6118);
let _e6134 = select(_e6132, _e6131, (_e6131 > _e6132));
let _e6137 = (select(_e6128, _e6118, (_e6118 > _e6128)) / select(1e-30f, _e6134, (_e6134 > 1e-30f)));
let _e6141 = select(0f, select(2f, _e6137, (_e6119 < 0f)), (_e6118 > 0f));
let _e6145 = select(2f, select(0f, _e6137, (_e6118 < 0f)), (_e6119 > 0f));
let _e6146 = (_e6118 > _e6084);
let _e6150 = ((_e6141 > _e6076) || ((_e6141 == _e6076) && _e6146));
let _e6151 = (_e6145 < _e6080);
let _e6152 = select(_e6076, _e6141, _e6150);
let _e6156 = select(_e6080, _e6145, _e6151);
let _e6160 = select(_e6084, _e6118, _e6146);
let _e6162 = select(_e6086, _e6119, (_e6119 > _e6086));
let _e6169 = global_1.member.member_18.member_1;
let _e6170 = (_e6169 != 0u);
let _e6174 = global_1.member.member_18.member;
let _e6194 = select(-1e6f, (((((_e6174.member.member * _e1130) + (_e6174.member.member_1 * _e1143)) + (_e6174.member.member_2 * _e1108)) + _e6174.member_1) * _e6013), _e6170);
let _e6195 = select(-1e6f, (((((_e6174.member.member * _e1153) + (_e6174.member.member_1 * _e1158)) + (_e6174.member.member_2 * _e1147)) + _e6174.member_1) * _e6013), _e6170);
let _e6200 = global_1.member.member_18.member.member;
let _e6204 = -(_e6194);
let _e6207 = (_e6194 - _e6195);
let _e6208 = (_e6195 - _e6194);
let _e6210 = select(_e6208, _e6207, (_e6207 > _e6208));
let _e6213 = (select(_e6204, _e6194, (_e6194 > _e6204)) / select(1e-30f, _e6210, (_e6210 > 1e-30f)));
let _e6217 = select(0f, select(2f, _e6213, (_e6195 < 0f)), (_e6194 > 0f));
let _e6221 = select(2f, select(0f, _e6213, (_e6194 < 0f)), (_e6195 > 0f));
let _e6222 = (_e6194 > _e6160);
let _e6226 = ((_e6217 > _e6152) || ((_e6217 == _e6152) && _e6222));
let _e6227 = (_e6221 < _e6156);
let _e6228 = select(_e6152, _e6217, _e6226);
let _e6232 = select(_e6156, _e6221, _e6227);
let _e6236 = select(_e6160, _e6194, _e6222);
let _e6238 = select(_e6162, _e6195, (_e6195 > _e6162));
let _e6245 = global_1.member.member_19.member_1;
let _e6246 = (_e6245 != 0u);
let _e6250 = global_1.member.member_19.member;
let _e6270 = select(-1e6f, (((((_e6250.member.member * _e1130) + (_e6250.member.member_1 * _e1143)) + (_e6250.member.member_2 * _e1108)) + _e6250.member_1) * _e6013), _e6246);
let _e6271 = select(-1e6f, (((((_e6250.member.member * _e1153) + (_e6250.member.member_1 * _e1158)) + (_e6250.member.member_2 * _e1147)) + _e6250.member_1) * _e6013), _e6246);
let _e6276 = global_1.member.member_19.member.member;
let _e6280 = -(_e6270);
let _e6283 = (_e6270 - _e6271);
let _e6284 = (_e6271 - _e6270);
let _e6286 = select(_e6284, _e6283, (_e6283 > _e6284));
let _e6289 = (select(_e6280, _e6270, (_e6270 > _e6280)) / select(1e-30f, _e6286, (_e6286 > 1e-30f)));
let _e6293 = select(0f, select(2f, _e6289, (_e6271 < 0f)), (_e6270 > 0f));
let _e6297 = select(2f, select(0f, _e6289, (_e6270 < 0f)), (_e6271 > 0f));
let _e6298 = (_e6270 > _e6236);
let _e6302 = ((_e6293 > _e6228) || ((_e6293 == _e6228) && _e6298));
let _e6303 = (_e6297 < _e6232);
phi_14001_ = type_34(select(_e6228, _e6293, _e6302), vec3<f32>(select(select(select(select(_e5989, _e6048.member, _e6074), _e6124.member, _e6150), _e6200.member, _e6226), _e6276.member, _e6302), select(select(select(select(_e5990, _e6048.member_1, _e6074), _e6124.member_1, _e6150), _e6200.member_1, _e6226), _e6276.member_1, _e6302), select(select(select(select(_e5991, _e6048.member_2, _e6074), _e6124.member_2, _e6150), _e6200.member_2, _e6226), _e6276.member_2, _e6302)), select(_e6232, _e6297, _e6303), vec3<f32>(select(select(select(select(_e5994, _e6048.member, _e6075), _e6124.member, _e6151), _e6200.member, _e6227), _e6276.member, _e6303), select(select(select(select(_e5995, _e6048.member_1, _e6075), _e6124.member_1, _e6151), _e6200.member_1, _e6227), _e6276.member_1, _e6303), select(select(select(select(_e5996, _e6048.member_2, _e6075), _e6124.member_2, _e6151), _e6200.member_2, _e6227), _e6276.member_2, _e6303)), select(_e6236, _e6270, _e6298), select(_e6238, _e6271, (_e6271 > _e6238)), vec3<f32>(select(select(select(select(_e6001, _e6048.member, _e6070), _e6124.member, _e6146), _e6200.member, _e6222), _e6276.member, _e6298), select(select(select(select(_e6002, _e6048.member_1, _e6070), _e6124.member_1, _e6146), _e6200.member_1, _e6222), _e6276.member_1, _e6298), select(select(select(select(_e6003, _e6048.member_2, _e6070), _e6124.member_2, _e6146), _e6200.member_2, _e6222), _e6276.member_2, _e6298)));
}
let _e6323 = phi_14001_;
let _e6325 = (_e6323.member_4 < 0f);
let _e6327 = (_e6323.member_5 < 0f);
let _e6328 = (_e6325 != _e6327);
if _e6325 {
phi_14014_ = _e6323.member_3;
phi_14015_ = _e6323.member_2;
} else {
phi_14014_ = _e6323.member_1;
phi_14015_ = _e6323.member;
}
let _e6334 = phi_14014_;
let _e6336 = phi_14015_;
let _e6345 = (((_e5745.member * _e5745.member) + (_e5745.member_1 * _e5745.member_1)) + (_e5745.member_2 * _e5745.member_2));
let _e6348 = sqrt(select(0f, _e6345, (_e6345 > 0f)));
let _e6349 = ((1.5f * _e1128) * _e6348);
let _e6354 = select(0f, _e6336, _e6328);
let _e6358 = (_e1130 + (_e4263 * _e6354));
let _e6359 = (_e1143 + (_e4264 * _e6354));
let _e6360 = (_e1108 + (_e4265 * _e6354));
let _e6366 = ((((_e1162.member.member * _e6358) + (_e1162.member.member_1 * _e6359)) + (_e1162.member.member_2 * _e6360)) + _e1162.member_1);
let _e6372 = ((((_e1177.member.member * _e6358) + (_e1177.member.member_1 * _e6359)) + (_e1177.member.member_2 * _e6360)) + _e1177.member_1);
let _e6378 = ((((_e1192.member.member * _e6358) + (_e1192.member.member_1 * _e6359)) + (_e1192.member.member_2 * _e6360)) + _e1192.member_1);
let _e6380 = select(-0.5f, _e6366, (_e6366 > -0.5f));
let _e6382 = select(_e3579, _e6380, (_e6380 < _e3579));
let _e6384 = select(-0.5f, _e6372, (_e6372 > -0.5f));
let _e6386 = select(_e3589, _e6384, (_e6384 < _e3589));
let _e6388 = select(-0.5f, _e6378, (_e6378 > -0.5f));
let _e6390 = select(_e3599, _e6388, (_e6388 < _e3599));
let _e6392 = select(-1f, _e6382, (_e6382 > -1f));
let _e6394 = select(_e3578, _e6392, (_e6392 < _e3578));
let _e6401 = select(0i, select(select(i32(_e6394), i32(-2147483648), (_e6394 < -2147483600f)), 2147483647i, (_e6394 > 2147483500f)), (_e6394 == _e6394));
let _e6405 = (_e6401 - select(0i, 1i, (_e6394 < f32(_e6401))));
let _e6407 = select(-1f, _e6386, (_e6386 > -1f));
let _e6409 = select(_e3588, _e6407, (_e6407 < _e3588));
let _e6416 = select(0i, select(select(i32(_e6409), i32(-2147483648), (_e6409 < -2147483600f)), 2147483647i, (_e6409 > 2147483500f)), (_e6409 == _e6409));
let _e6420 = (_e6416 - select(0i, 1i, (_e6409 < f32(_e6416))));
let _e6422 = select(-1f, _e6390, (_e6390 > -1f));
let _e6424 = select(_e3598, _e6422, (_e6422 < _e3598));
let _e6431 = select(0i, select(select(i32(_e6424), i32(-2147483648), (_e6424 < -2147483600f)), 2147483647i, (_e6424 > 2147483500f)), (_e6424 == _e6424));
let _e6435 = (_e6431 - select(0i, 1i, (_e6424 < f32(_e6431))));
let _e6436 = (_e6405 + 1i);
let _e6437 = (_e6420 + 1i);
let _e6438 = (_e6435 + 1i);
let _e6448 = ((_e6436 >> bitcast<u32>(4i)) + (_e3665 * ((_e6437 >> bitcast<u32>(4i)) + (_e3671 * (_e6438 >> bitcast<u32>(4i))))));
let _e6450 = select(_e3683, _e6448, (_e6448 < _e3683));
let _e6456 = global_2.member[bitcast<u32>(select(0i, _e6450, (_e6450 > 0i)))];
let _e6458 = (_e6436 & 15i);
let _e6461 = ((_e6437 & 15i) * _e3652);
let _e6463 = (bitcast<i32>(_e6456) + ((_e6438 & 15i) * _e3656));
let _e6467 = (_e6461 + _e3652);
let _e6468 = (_e6461 + _e3703);
let _e6469 = (_e6463 + _e3656);
let _e6470 = (_e6463 + _e3706);
local_2 = type_29(array<i32, 4>(_e6458, (_e6458 + 1i), (_e6458 + 2i), (_e6458 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e6382 - f32(_e6405)), (_e6386 - f32(_e6420)), (_e6390 - f32(_e6435)));
let _e6484 = local_2.member[1u];
let _e6485 = ((_e6469 + _e6467) + _e6484);
let _e6487 = (_e6485 >> bitcast<u32>(1i));
let _e6490 = bitcast<u32>(((_e6485 & 1i) * 16i));
let _e6492 = select(_e3683, _e6487, (_e6487 < _e3683));
let _e6497 = global_2.member[bitcast<u32>(select(0i, _e6492, (_e6492 > 0i)))];
let _e6501 = (_e6487 + 1i);
let _e6503 = select(_e3683, _e6501, (_e6501 < _e3683));
let _e6508 = global_2.member[bitcast<u32>(select(0i, _e6503, (_e6503 > 0i)))];
let _e6515 = ((_e6497 >> bitcast<u32>((_e6490 & 31u))) | ((_e6508 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6490) & 31u))));
let _e6518 = local_2.member_1[2u];
let _e6524 = f32(bitcast<i32>(((_e6515 >> bitcast<u32>((_e6518 & 31u))) & 65535u)));
let _e6527 = local_2.member_1[3u];
let _e6534 = local_3[0u];
let _e6537 = (_e6524 + ((f32(bitcast<i32>(((_e6515 >> bitcast<u32>((_e6527 & 31u))) & 65535u))) - _e6524) * _e6534));
let _e6539 = local_2.member[1u];
let _e6540 = ((_e6469 + _e6468) + _e6539);
let _e6542 = (_e6540 >> bitcast<u32>(1i));
let _e6545 = bitcast<u32>(((_e6540 & 1i) * 16i));
let _e6547 = select(_e3683, _e6542, (_e6542 < _e3683));
let _e6552 = global_2.member[bitcast<u32>(select(0i, _e6547, (_e6547 > 0i)))];
let _e6556 = (_e6542 + 1i);
let _e6558 = select(_e3683, _e6556, (_e6556 < _e3683));
let _e6563 = global_2.member[bitcast<u32>(select(0i, _e6558, (_e6558 > 0i)))];
let _e6570 = ((_e6552 >> bitcast<u32>((_e6545 & 31u))) | ((_e6563 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6545) & 31u))));
let _e6571 = local_2.member_1[2u];
let _e6577 = f32(bitcast<i32>(((_e6570 >> bitcast<u32>((_e6571 & 31u))) & 65535u)));
let _e6578 = local_2.member_1[3u];
let _e6585 = local_3[0u];
let _e6590 = local_3[1u];
let _e6593 = (_e6537 + (((_e6577 + ((f32(bitcast<i32>(((_e6570 >> bitcast<u32>((_e6578 & 31u))) & 65535u))) - _e6577) * _e6585)) - _e6537) * _e6590));
let _e6595 = local_2.member[1u];
let _e6596 = ((_e6470 + _e6467) + _e6595);
let _e6598 = (_e6596 >> bitcast<u32>(1i));
let _e6601 = bitcast<u32>(((_e6596 & 1i) * 16i));
let _e6603 = select(_e3683, _e6598, (_e6598 < _e3683));
let _e6608 = global_2.member[bitcast<u32>(select(0i, _e6603, (_e6603 > 0i)))];
let _e6612 = (_e6598 + 1i);
let _e6614 = select(_e3683, _e6612, (_e6612 < _e3683));
let _e6619 = global_2.member[bitcast<u32>(select(0i, _e6614, (_e6614 > 0i)))];
let _e6626 = ((_e6608 >> bitcast<u32>((_e6601 & 31u))) | ((_e6619 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6601) & 31u))));
let _e6627 = local_2.member_1[2u];
let _e6633 = f32(bitcast<i32>(((_e6626 >> bitcast<u32>((_e6627 & 31u))) & 65535u)));
let _e6634 = local_2.member_1[3u];
let _e6641 = local_3[0u];
let _e6644 = (_e6633 + ((f32(bitcast<i32>(((_e6626 >> bitcast<u32>((_e6634 & 31u))) & 65535u))) - _e6633) * _e6641));
let _e6646 = local_2.member[1u];
let _e6647 = ((_e6470 + _e6468) + _e6646);
let _e6649 = (_e6647 >> bitcast<u32>(1i));
let _e6652 = bitcast<u32>(((_e6647 & 1i) * 16i));
let _e6654 = select(_e3683, _e6649, (_e6649 < _e3683));
let _e6659 = global_2.member[bitcast<u32>(select(0i, _e6654, (_e6654 > 0i)))];
let _e6663 = (_e6649 + 1i);
let _e6665 = select(_e3683, _e6663, (_e6663 < _e3683));
let _e6670 = global_2.member[bitcast<u32>(select(0i, _e6665, (_e6665 > 0i)))];
let _e6677 = ((_e6659 >> bitcast<u32>((_e6652 & 31u))) | ((_e6670 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6652) & 31u))));
let _e6678 = local_2.member_1[2u];
let _e6684 = f32(bitcast<i32>(((_e6677 >> bitcast<u32>((_e6678 & 31u))) & 65535u)));
let _e6685 = local_2.member_1[3u];
let _e6692 = local_3[0u];
let _e6696 = local_3[1u];
let _e6701 = local_3[2u];
let _e6706 = (((_e6593 + (((_e6644 + (((_e6684 + ((f32(bitcast<i32>(((_e6677 >> bitcast<u32>((_e6685 & 31u))) & 65535u))) - _e6684) * _e6692)) - _e6644) * _e6696)) - _e6593) * _e6701)) - _e3945) * _e3949);
let _e6708 = select(_e3952, _e6706, (_e6706 > _e3952));
local = select(1e9f, _e6708, (_e6708 < 1e9f));
let _e6711 = local;
local_1 = _e6711;
let _e6712 = local_1;
let _e6714 = (bitcast<i32>(_e166) - 1i);
let _e6716 = select(_e6714, 263197i, (263197i < _e6714));
let _e6721 = global_3.member[bitcast<u32>(select(0i, _e6716, (_e6716 > 0i)))];
let _e6724 = select(_e6714, 263198i, (263198i < _e6714));
let _e6729 = global_3.member[bitcast<u32>(select(0i, _e6724, (_e6724 > 0i)))];
let _e6732 = select(_e6714, 263199i, (263199i < _e6714));
let _e6737 = global_3.member[bitcast<u32>(select(0i, _e6732, (_e6732 > 0i)))];
let _e6738 = bitcast<f32>(_e6737);
let _e6740 = ((_e6712 - bitcast<f32>(_e6721)) * bitcast<f32>(_e6729));
let _e6742 = select(0f, _e6740, (_e6740 > 0f));
let _e6745 = local_1;
let _e6747 = select(_e6714, 263200i, (263200i < _e6714));
let _e6752 = global_3.member[bitcast<u32>(select(0i, _e6747, (_e6747 > 0i)))];
let _e6755 = select(_e6714, 263201i, (263201i < _e6714));
let _e6760 = global_3.member[bitcast<u32>(select(0i, _e6755, (_e6755 > 0i)))];
let _e6763 = select(_e6714, 263202i, (263202i < _e6714));
let _e6768 = global_3.member[bitcast<u32>(select(0i, _e6763, (_e6763 > 0i)))];
let _e6769 = bitcast<f32>(_e6768);
let _e6771 = ((_e6745 - bitcast<f32>(_e6752)) * bitcast<f32>(_e6760));
let _e6773 = select(0f, _e6771, (_e6771 > 0f));
let _e6777 = local_1;
let _e6779 = select(_e6714, 263203i, (263203i < _e6714));
let _e6784 = global_3.member[bitcast<u32>(select(0i, _e6779, (_e6779 > 0i)))];
let _e6787 = select(_e6714, 263204i, (263204i < _e6714));
let _e6792 = global_3.member[bitcast<u32>(select(0i, _e6787, (_e6787 > 0i)))];
let _e6795 = select(_e6714, 263205i, (263205i < _e6714));
let _e6800 = global_3.member[bitcast<u32>(select(0i, _e6795, (_e6795 > 0i)))];
let _e6801 = bitcast<f32>(_e6800);
let _e6803 = ((_e6777 - bitcast<f32>(_e6784)) * bitcast<f32>(_e6792));
let _e6805 = select(0f, _e6803, (_e6803 > 0f));
let _e6808 = local_1;
let _e6810 = select(_e6714, 263206i, (263206i < _e6714));
let _e6815 = global_3.member[bitcast<u32>(select(0i, _e6810, (_e6810 > 0i)))];
let _e6818 = select(_e6714, 263207i, (263207i < _e6714));
let _e6823 = global_3.member[bitcast<u32>(select(0i, _e6818, (_e6818 > 0i)))];
let _e6826 = select(_e6714, 263208i, (263208i < _e6714));
let _e6831 = global_3.member[bitcast<u32>(select(0i, _e6826, (_e6826 > 0i)))];
let _e6832 = bitcast<f32>(_e6831);
let _e6834 = ((_e6808 - bitcast<f32>(_e6815)) * bitcast<f32>(_e6823));
let _e6836 = select(0f, _e6834, (_e6834 > 0f));
let _e6840 = ((select(_e6738, _e6742, (_e6742 < _e6738)) + select(_e6769, _e6773, (_e6773 < _e6769))) + (select(_e6801, _e6805, (_e6805 < _e6801)) + select(_e6832, _e6836, (_e6836 < _e6832))));
let _e6842 = select(0f, _e6840, (_e6840 > 0f));
let _e6844 = select(1023f, _e6842, (_e6842 < 1023f));
let _e6851 = select(0i, select(select(i32(_e6844), i32(-2147483648), (_e6844 < -2147483600f)), 2147483647i, (_e6844 > 2147483500f)), (_e6844 == _e6844));
let _e6855 = (_e6851 - select(0i, 1i, (_e6844 < f32(_e6851))));
let _e6856 = (262147i + _e6855);
let _e6858 = select(_e6714, _e6856, (_e6856 < _e6714));
let _e6864 = global_3.member[bitcast<u32>(select(0i, _e6858, (_e6858 > 0i)))];
let _e6874 = select(_e6714, 262146i, (262146i < _e6714));
let _e6880 = global_3.member[bitcast<u32>(select(0i, _e6874, (_e6874 > 0i)))];
let _e6884 = select(_e6714, 262144i, (262144i < _e6714));
let _e6890 = global_3.member[bitcast<u32>(select(0i, _e6884, (_e6884 > 0i)))];
let _e6893 = select(_e6714, 262145i, (262145i < _e6714));
let _e6899 = global_3.member[bitcast<u32>(select(0i, _e6893, (_e6893 > 0i)))];
let _e6906 = ((bitcast<f32>(_e6890) + (f32(bitcast<i32>((_e6864 >> bitcast<u32>(12u)))) * bitcast<f32>(_e6899))) + ((f32((bitcast<i32>((_e6864 & 4095u)) - 2048i)) * bitcast<f32>(_e6880)) * (_e6840 - f32(_e6855))));
let _e6910 = select(_e6323.member_6.x, _e6334.x, _e6328);
let _e6913 = select(_e6323.member_6.y, _e6334.y, _e6328);
let _e6916 = select(_e6323.member_6.z, _e6334.z, _e6328);
let _e6917 = select(1f, _e6906, _e6327);
let _e6922 = (((_e6910 * _e6910) + (_e6913 * _e6913)) + (_e6916 * _e6916));
let _e6925 = sqrt(select(0f, _e6922, (_e6922 > 0f)));
let _e6928 = (1f / select(1e-20f, _e6925, (_e6925 > 1e-20f)));
let _e6929 = (_e6910 * _e6928);
let _e6930 = (_e6913 * _e6928);
let _e6931 = (_e6916 * _e6928);
let _e6936 = (((_e234 * _e6929) + (_e245 * _e6930)) + (_e256 * _e6931));
let _e6941 = (((_e234 * _e234) + (_e245 * _e245)) + (_e256 * _e256));
let _e6943 = ((_e6917 * _e6917) - _e6941);
let _e6944 = (_e6936 * _e6936);
let _e6945 = (_e6944 + _e6943);
let _e6948 = sqrt(select(0f, _e6945, (_e6945 > 0f)));
let _e6952 = (_e6945 <= 0f);
let _e6955 = select((select(_e6948, -(_e6948), (_e6936 < 0f)) - _e6936), (-2f * _e6936), _e6952);
let _e6956 = (_e6943 == 0f);
let _e6967 = (_e6952 && (_e6943 != 0f));
let _e6973 = (!(_e6328) && (_e6967 || (_e6944 < ((0.1f * 0.1f) * _e6941))));
let _e6975 = select(1e-12f, _e6941, (_e6941 > 1e-12f));
let _e6979 = (_e6917 / sqrt(select(0f, _e6975, (_e6975 > 0f))));
let _e6991 = ((_e6328 || (bitcast<f32>((bitcast<u32>(_e6323.member_4) & 2147483647u)) < select(1f, _e6349, (_e6349 < 1f)))) && (_e6906 != 1f));
let _e6992 = select(_e234, select(select(select((_e234 + (_e6929 * _e6955)), _e234, _e6956), _e234, _e6967), (_e234 * _e6979), _e6973), _e6991);
let _e6993 = select(_e245, select(select(select((_e245 + (_e6930 * _e6955)), _e245, _e6956), _e245, _e6967), (_e245 * _e6979), _e6973), _e6991);
let _e6994 = select(_e256, select(select(select((_e256 + (_e6931 * _e6955)), _e256, _e6956), _e256, _e6967), (_e256 * _e6979), _e6973), _e6991);
let _e7006 = global_1.member.member_7.member_2;
let _e7009 = (_e7006 / select(1e-6f, _e6994, (_e6994 > 1e-6f)));
let _e7013 = (_e1153 + (_e6992 * _e7009));
let _e7014 = (_e1158 + (_e6993 * _e7009));
let _e7015 = (_e1147 + (_e6994 * _e7009));
let _e7021 = ((((_e1162.member.member * _e7013) + (_e1162.member.member_1 * _e7014)) + (_e1162.member.member_2 * _e7015)) + _e1162.member_1);
let _e7027 = ((((_e1177.member.member * _e7013) + (_e1177.member.member_1 * _e7014)) + (_e1177.member.member_2 * _e7015)) + _e1177.member_1);
let _e7033 = ((((_e1192.member.member * _e7013) + (_e1192.member.member_1 * _e7014)) + (_e1192.member.member_2 * _e7015)) + _e1192.member_1);
let _e7034 = (-0.5f - _e7021);
let _e7035 = -(_e5765);
let _e7038 = (_e5765 - _e7034);
let _e7039 = (_e7034 - _e5765);
let _e7041 = select(_e7039, _e7038, (_e7038 > _e7039));
let _e7044 = (select(_e7035, _e5765, (_e5765 > _e7035)) / select(1e-30f, _e7041, (_e7041 > 1e-30f)));
let _e7047 = select(0f, select(2f, _e7044, (_e7034 < 0f)), _e5780);
let _e7050 = select(2f, select(0f, _e7044, _e5777), (_e7034 > 0f));
let _e7054 = ((_e7047 > -1f) || ((_e7047 == -1f) && _e5799));
let _e7055 = (_e7050 < 2f);
let _e7056 = select(-1f, _e7047, _e7054);
let _e7060 = select(2f, _e7050, _e7055);
let _e7065 = select(-1e30f, _e7034, (_e7034 > -1e30f));
let _e7069 = (_e7021 - _e3579);
let _e7070 = -(_e5805);
let _e7073 = (_e5805 - _e7069);
let _e7074 = (_e7069 - _e5805);
let _e7076 = select(_e7074, _e7073, (_e7073 > _e7074));
let _e7079 = (select(_e7070, _e5805, (_e5805 > _e7070)) / select(1e-30f, _e7076, (_e7076 > 1e-30f)));
let _e7082 = select(0f, select(2f, _e7079, (_e7069 < 0f)), _e5820);
let _e7085 = select(2f, select(0f, _e7079, _e5817), (_e7069 > 0f));
let _e7089 = ((_e7082 > _e7056) || ((_e7082 == _e7056) && _e5839));
let _e7090 = (_e7085 < _e7060);
let _e7091 = select(_e7056, _e7082, _e7089);
let _e7095 = select(_e7060, _e7085, _e7090);
let _e7100 = select(_e7065, _e7069, (_e7069 > _e7065));
let _e7104 = (-0.5f - _e7027);
let _e7105 = -(_e5844);
let _e7108 = (_e5844 - _e7104);
let _e7109 = (_e7104 - _e5844);
let _e7111 = select(_e7109, _e7108, (_e7108 > _e7109));
let _e7114 = (select(_e7105, _e5844, (_e5844 > _e7105)) / select(1e-30f, _e7111, (_e7111 > 1e-30f)));
let _e7117 = select(0f, select(2f, _e7114, (_e7104 < 0f)), _e5859);
let _e7120 = select(2f, select(0f, _e7114, _e5856), (_e7104 > 0f));
let _e7124 = ((_e7117 > _e7091) || ((_e7117 == _e7091) && _e5878));
let _e7125 = (_e7120 < _e7095);
let _e7126 = select(_e7091, _e7117, _e7124);
let _e7130 = select(_e7095, _e7120, _e7125);
let _e7135 = select(_e7100, _e7104, (_e7104 > _e7100));
let _e7139 = (_e7027 - _e3589);
let _e7140 = -(_e5884);
let _e7143 = (_e5884 - _e7139);
let _e7144 = (_e7139 - _e5884);
let _e7146 = select(_e7144, _e7143, (_e7143 > _e7144));
let _e7149 = (select(_e7140, _e5884, (_e5884 > _e7140)) / select(1e-30f, _e7146, (_e7146 > 1e-30f)));
let _e7152 = select(0f, select(2f, _e7149, (_e7139 < 0f)), _e5899);
let _e7155 = select(2f, select(0f, _e7149, _e5896), (_e7139 > 0f));
let _e7159 = ((_e7152 > _e7126) || ((_e7152 == _e7126) && _e5918));
let _e7160 = (_e7155 < _e7130);
let _e7161 = select(_e7126, _e7152, _e7159);
let _e7165 = select(_e7130, _e7155, _e7160);
let _e7170 = select(_e7135, _e7139, (_e7139 > _e7135));
let _e7174 = (-0.5f - _e7033);
let _e7175 = -(_e5923);
let _e7178 = (_e5923 - _e7174);
let _e7179 = (_e7174 - _e5923);
let _e7181 = select(_e7179, _e7178, (_e7178 > _e7179));
let _e7184 = (select(_e7175, _e5923, (_e5923 > _e7175)) / select(1e-30f, _e7181, (_e7181 > 1e-30f)));
let _e7187 = select(0f, select(2f, _e7184, (_e7174 < 0f)), _e5938);
let _e7190 = select(2f, select(0f, _e7184, _e5935), (_e7174 > 0f));
let _e7194 = ((_e7187 > _e7161) || ((_e7187 == _e7161) && _e5957));
let _e7195 = (_e7190 < _e7165);
let _e7196 = select(_e7161, _e7187, _e7194);
let _e7200 = select(_e7165, _e7190, _e7195);
let _e7205 = select(_e7170, _e7174, (_e7174 > _e7170));
let _e7209 = (_e7033 - _e3599);
let _e7210 = -(_e5963);
let _e7213 = (_e5963 - _e7209);
let _e7214 = (_e7209 - _e5963);
let _e7216 = select(_e7214, _e7213, (_e7213 > _e7214));
let _e7219 = (select(_e7210, _e5963, (_e5963 > _e7210)) / select(1e-30f, _e7216, (_e7216 > 1e-30f)));
let _e7222 = select(0f, select(2f, _e7219, (_e7209 < 0f)), _e5978);
let _e7225 = select(2f, select(0f, _e7219, _e5975), (_e7209 > 0f));
let _e7229 = ((_e7222 > _e7196) || ((_e7222 == _e7196) && _e5999));
let _e7230 = (_e7225 < _e7200);
let _e7231 = select(_e7196, _e7222, _e7229);
let _e7232 = select(select(select(select(select(select(0f, _e5745.member, _e7054), _e5745.member, _e7089), _e5753.member, _e7124), _e5753.member, _e7159), _e5761.member, _e7194), _e5761.member, _e7229);
let _e7233 = select(select(select(select(select(select(0f, _e5745.member_1, _e7054), _e5745.member_1, _e7089), _e5753.member_1, _e7124), _e5753.member_1, _e7159), _e5761.member_1, _e7194), _e5761.member_1, _e7229);
let _e7234 = select(select(select(select(select(select(1f, _e5745.member_2, _e7054), _e5745.member_2, _e7089), _e5753.member_2, _e7124), _e5753.member_2, _e7159), _e5761.member_2, _e7194), _e5761.member_2, _e7229);
let _e7236 = select(_e7200, _e7225, _e7230);
let _e7237 = select(select(select(select(select(select(0f, _e5745.member, _e7055), _e5745.member, _e7090), _e5753.member, _e7125), _e5753.member, _e7160), _e5761.member, _e7195), _e5761.member, _e7230);
let _e7238 = select(select(select(select(select(select(0f, _e5745.member_1, _e7055), _e5745.member_1, _e7090), _e5753.member_1, _e7125), _e5753.member_1, _e7160), _e5761.member_1, _e7195), _e5761.member_1, _e7230);
let _e7239 = select(select(select(select(select(select(1f, _e5745.member_2, _e7055), _e5745.member_2, _e7090), _e5753.member_2, _e7125), _e5753.member_2, _e7160), _e5761.member_2, _e7195), _e5761.member_2, _e7230);
let _e7242 = select(_e7205, _e7209, (_e7209 > _e7205));
let _e7243 = select(select(select(select(select(select(0f, _e5745.member, _e5799), _e5745.member, _e5839), _e5753.member, _e5878), _e5753.member, _e5918), _e5761.member, _e5957), _e5761.member, _e5999);
let _e7244 = select(select(select(select(select(select(0f, _e5745.member_1, _e5799), _e5745.member_1, _e5839), _e5753.member_1, _e5878), _e5753.member_1, _e5918), _e5761.member_1, _e5957), _e5761.member_1, _e5999);
let _e7245 = select(select(select(select(select(select(1f, _e5745.member_2, _e5799), _e5745.member_2, _e5839), _e5753.member_2, _e5878), _e5753.member_2, _e5918), _e5761.member_2, _e5957), _e5761.member_2, _e5999);
if _e3961 {
phi_16686_ = type_34(_e7231, vec3<f32>(_e7232, _e7233, _e7234), _e7236, vec3<f32>(_e7237, _e7238, _e7239), _e6000, _e7242, vec3<f32>(_e7243, _e7244, _e7245));
} else {
let _e7251 = global_1.member.member_16.member_1;
let _e7252 = (_e7251 != 0u);
let _e7256 = global_1.member.member_16.member;
let _e7276 = select(-1e6f, (((((_e7256.member.member * _e1153) + (_e7256.member.member_1 * _e1158)) + (_e7256.member.member_2 * _e1147)) + _e7256.member_1) * _e6348), _e7252);
let _e7277 = select(-1e6f, (((((_e7256.member.member * _e7013) + (_e7256.member.member_1 * _e7014)) + (_e7256.member.member_2 * _e7015)) + _e7256.member_1) * _e6348), _e7252);
let _e7282 = global_1.member.member_16.member.member;
let _e7286 = -(_e7276);
let _e7289 = (_e7276 - _e7277);
let _e7290 = (_e7277 - _e7276);
let _e7292 = select(_e7290, _e7289, (_e7289 > _e7290));
let _e7295 = (select(_e7286, _e7276, (_e7276 > _e7286)) / select(1e-30f, _e7292, (_e7292 > 1e-30f)));
let _e7299 = select(0f, select(2f, _e7295, (_e7277 < 0f)), (_e7276 > 0f));
let _e7303 = select(2f, select(0f, _e7295, (_e7276 < 0f)), (_e7277 > 0f));
let _e7304 = (_e7276 > _e6000);
let _e7308 = ((_e7299 > _e7231) || ((_e7299 == _e7231) && _e7304));
let _e7309 = (_e7303 < _e7236);
let _e7310 = select(_e7231, _e7299, _e7308);
let _e7314 = select(_e7236, _e7303, _e7309);
let _e7318 = select(_e6000, _e7276, _e7304);
let _e7320 = select(_e7242, _e7277, (_e7277 > _e7242));
let _e7327 = global_1.member.member_17.member_1;
let _e7328 = (_e7327 != 0u);
let _e7332 = global_1.member.member_17.member;
let _e7352 = select(-1e6f, (((((_e7332.member.member * _e1153) + (_e7332.member.member_1 * _e1158)) + (_e7332.member.member_2 * _e1147)) + _e7332.member_1) * _e6348), _e7328);
let _e7353 = select(-1e6f, (((((_e7332.member.member * _e7013) + (_e7332.member.member_1 * _e7014)) + (_e7332.member.member_2 * _e7015)) + _e7332.member_1) * _e6348), _e7328);
let _e7358 = global_1.member.member_17.member.member;
let _e7362 = -(_e7352);
let _e7365 = (_e7352 - _e7353);
let _e7366 = (_e7353 - _e7352);
let _e7368 = select(_e7366, _e7365, (_e7365 > _e7366));
let _e7371 = (select(_e7362, _e7352, (_e7352 > _e7362)) / select(1e-30f, _e7368, (_e7368 > 1e-30f)));
let _e7375 = select(0f, select(2f, _e7371, (_e7353 < 0f)), (_e7352 > 0f));
let _e7379 = select(2f, select(0f, _e7371, (_e7352 < 0f)), (_e7353 > 0f));
let _e7380 = (_e7352 > _e7318);
let _e7384 = ((_e7375 > _e7310) || ((_e7375 == _e7310) && _e7380));
let _e7385 = (_e7379 < _e7314);
let _e7386 = select(_e7310, _e7375, _e7384);
let _e7390 = select(_e7314, _e7379, _e7385);
let _e7394 = select(_e7318, _e7352, _e7380);
let _e7396 = select(_e7320, _e7353, (_e7353 > _e7320));
let _e7403 = global_1.member.member_18.member_1;
let _e7404 = (_e7403 != 0u);
let _e7408 = global_1.member.member_18.member;
let _e7428 = select(-1e6f, (((((_e7408.member.member * _e1153) + (_e7408.member.member_1 * _e1158)) + (_e7408.member.member_2 * _e1147)) + _e7408.member_1) * _e6348), _e7404);
let _e7429 = select(-1e6f, (((((_e7408.member.member * _e7013) + (_e7408.member.member_1 * _e7014)) + (_e7408.member.member_2 * _e7015)) + _e7408.member_1) * _e6348), _e7404);
let _e7434 = global_1.member.member_18.member.member;
let _e7438 = -(_e7428);
let _e7441 = (_e7428 - _e7429);
let _e7442 = (_e7429 - _e7428);
let _e7444 = select(_e7442, _e7441, (_e7441 > _e7442));
let _e7447 = (select(_e7438, _e7428, (_e7428 > _e7438)) / select(1e-30f, _e7444, (_e7444 > 1e-30f)));
let _e7451 = select(0f, select(2f, _e7447, (_e7429 < 0f)), (_e7428 > 0f));
let _e7455 = select(2f, select(0f, _e7447, (_e7428 < 0f)), (_e7429 > 0f));
let _e7456 = (_e7428 > _e7394);
let _e7460 = ((_e7451 > _e7386) || ((_e7451 == _e7386) && _e7456));
let _e7461 = (_e7455 < _e7390);
let _e7462 = select(_e7386, _e7451, _e7460);
let _e7466 = select(_e7390, _e7455, _e7461);
let _e7470 = select(_e7394, _e7428, _e7456);
let _e7472 = select(_e7396, _e7429, (_e7429 > _e7396));
let _e7479 = global_1.member.member_19.member_1;
let _e7480 = (_e7479 != 0u);
let _e7484 = global_1.member.member_19.member;
let _e7504 = select(-1e6f, (((((_e7484.member.member * _e1153) + (_e7484.member.member_1 * _e1158)) + (_e7484.member.member_2 * _e1147)) + _e7484.member_1) * _e6348), _e7480);
let _e7505 = select(-1e6f, (((((_e7484.member.member * _e7013) + (_e7484.member.member_1 * _e7014)) + (_e7484.member.member_2 * _e7015)) + _e7484.member_1) * _e6348), _e7480);
let _e7510 = global_1.member.member_19.member.member;
let _e7514 = -(_e7504);
let _e7517 = (_e7504 - _e7505);
let _e7518 = (_e7505 - _e7504);
let _e7520 = select(_e7518, _e7517, (_e7517 > _e7518));
let _e7523 = (select(_e7514, _e7504, (_e7504 > _e7514)) / select(1e-30f, _e7520, (_e7520 > 1e-30f)));
let _e7527 = select(0f, select(2f, _e7523, (_e7505 < 0f)), (_e7504 > 0f));
let _e7531 = select(2f, select(0f, _e7523, (_e7504 < 0f)), (_e7505 > 0f));
let _e7532 = (_e7504 > _e7470);
let _e7536 = ((_e7527 > _e7462) || ((_e7527 == _e7462) && _e7532));
let _e7537 = (_e7531 < _e7466);
phi_16686_ = type_34(select(_e7462, _e7527, _e7536), vec3<f32>(select(select(select(select(_e7232, _e7282.member, _e7308), _e7358.member, _e7384), _e7434.member, _e7460), _e7510.member, _e7536), select(select(select(select(_e7233, _e7282.member_1, _e7308), _e7358.member_1, _e7384), _e7434.member_1, _e7460), _e7510.member_1, _e7536), select(select(select(select(_e7234, _e7282.member_2, _e7308), _e7358.member_2, _e7384), _e7434.member_2, _e7460), _e7510.member_2, _e7536)), select(_e7466, _e7531, _e7537), vec3<f32>(select(select(select(select(_e7237, _e7282.member, _e7309), _e7358.member, _e7385), _e7434.member, _e7461), _e7510.member, _e7537), select(select(select(select(_e7238, _e7282.member_1, _e7309), _e7358.member_1, _e7385), _e7434.member_1, _e7461), _e7510.member_1, _e7537), select(select(select(select(_e7239, _e7282.member_2, _e7309), _e7358.member_2, _e7385), _e7434.member_2, _e7461), _e7510.member_2, _e7537)), select(_e7470, _e7504, _e7532), select(_e7472, _e7505, (_e7505 > _e7472)), vec3<f32>(select(select(select(select(_e7243, _e7282.member, _e7304), _e7358.member, _e7380), _e7434.member, _e7456), _e7510.member, _e7532), select(select(select(select(_e7244, _e7282.member_1, _e7304), _e7358.member_1, _e7380), _e7434.member_1, _e7456), _e7510.member_1, _e7532), select(select(select(select(_e7245, _e7282.member_2, _e7304), _e7358.member_2, _e7380), _e7434.member_2, _e7456), _e7510.member_2, _e7532)));
}
let _e7557 = phi_16686_;
let _e7566 = global_1.member.member_7.member_4;
let _e7569 = (_e3573.member_3.x * _e4164.member_2);
let _e7571 = (_e3573.member_3.y * _e4164.member_2);
let _e7573 = (_e3573.member_3.z * _e4164.member_2);
let _e7574 = (0.5f * (_e7009 * select(1f, (2f * (1f - _e6336)), (_e6328 && _e6327))));
let _e7578 = (_e6992 + (_e7569 * _e7574));
let _e7579 = (_e6993 + (_e7571 * _e7574));
let _e7580 = (_e6994 + (_e7573 * _e7574));
let _e7582 = (2f * _e7006);
let _e7584 = ((_e7580 * _e7580) + (_e7582 * _e7573));
let _e7588 = (_e7580 + sqrt(select(0f, _e7584, (_e7584 > 0f))));
let _e7592 = (select(0.5f, _e7557.member_2, (_e7557.member_2 < 1f)) * (_e7582 / select(1e-6f, _e7588, (_e7588 > 1e-6f))));
let _e7596 = (_e7578 + (_e7569 * _e7592));
let _e7597 = (_e7579 + (_e7571 * _e7592));
let _e7598 = (_e7580 + (_e7573 * _e7592));
let _e7602 = (_e7566 * _e7566);
let _e7604 = (_e7598 * _e7598);
let _e7612 = (((_e7580 <= 0f) || (_e7584 <= 0f)) || ((_e7598 <= 0f) || (_e7604 <= (_e7602 * (((_e7596 * _e7596) + (_e7597 * _e7597)) + _e7604)))));
let _e7626 = (_e6992 + ((_e3573.member_4.x * _e4164.member_2) * _e7006));
let _e7627 = (_e6993 + ((_e3573.member_4.y * _e4164.member_2) * _e7006));
let _e7628 = (_e6994 + ((_e3573.member_4.z * _e4164.member_2) * _e7006));
let _e7630 = (_e7628 * _e7628);
let _e7639 = ((_e3959 & 1u) != 0u);
let _e7644 = (select(_e7612, ((_e7628 <= 0f) || (_e7630 <= (_e7602 * (((_e7626 * _e7626) + (_e7627 * _e7627)) + _e7630)))), _e7639) || (_e6991 && ((_e6967 && _e6328) || (_e6328 && (_e6994 <= 0f)))));
phi_16838_ = vec3<f32>(select(select(select(_e7596, _e7578, _e7612), _e7626, _e7639), _e234, _e7644), select(select(select(_e7597, _e7579, _e7612), _e7627, _e7639), _e245, _e7644), select(select(select(_e7598, _e7580, _e7612), _e7628, _e7639), _e256, _e7644));
phi_16839_ = select(1f, 0f, _e7644);
} else {
phi_16838_ = vec3<f32>(_e234, _e245, _e256);
phi_16839_ = 1f;
}
let _e7651 = phi_16838_;
let _e7653 = phi_16839_;
let _e7656 = (_e5740.member * _e7653);
global_4.member[_e191] = (_e202 * (_e5740.member_2.x * _e7656));
global_4.member[_e203] = (_e212 * (_e5740.member_2.y * _e7656));
global_4.member[_e214] = (_e223 * (_e5740.member_2.z * _e7656));
global_4.member[_e225] = _e7651.x;
global_4.member[_e236] = _e7651.y;
global_4.member[_e247] = _e7651.z;
global_4.member[_e258] = _e267;
global_4.member[_e269] = _e278;
global_4.member[_e280] = _e289;
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
